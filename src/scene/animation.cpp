#include "scene/animation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hm {
namespace {

// Two neighbouring keys and the interpolation parameter between them, 0 to 1.
struct Span {
    std::size_t first = 0, second = 0;
    double fraction = 0;
    double seconds = 0;  // between the keys
};

Span find_span(const std::vector<float>& times, double seconds) {
    const std::size_t last = times.size() - 1;
    if (!(seconds >= double(times.front()))) return {};
    if (seconds >= double(times.back())) return {last, last, 0, 0};
    const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                        [](double t, float key) { return t < double(key); });
    const std::size_t second = std::size_t(after - times.begin());
    const double begin = double(times[second - 1]);
    const double length = double(times[second]) - begin;
    return {second - 1, second, (seconds - begin) / length, length};
}

// The value of a key, without its in- and out-tangents.
const float* value_at(const AnimationSampler& s, std::size_t key) {
    const std::size_t width = s.width();
    if (s.interpolation == Interpolation::cubic_spline)
        return s.values.data() + (3 * key + 1) * width;
    return s.values.data() + key * width;
}

// Cubic Hermite basis (Appendix C.4). Tangents are per second.
template <class Number>
void interpolate_cubic(const AnimationSampler& s, const Span& at, std::span<Number> out) {
    const std::size_t width = out.size();
    const float* v0 = value_at(s, at.first);
    const float* v1 = value_at(s, at.second);
    const float* out_tangent = v0 + width;
    const float* in_tangent = v1 - width;
    const double t = at.fraction, t2 = t * t, t3 = t2 * t;
    for (std::size_t i = 0; i < width; ++i)
        out[i] = Number((2 * t3 - 3 * t2 + 1) * double(v0[i]) +
                        at.seconds * (t3 - 2 * t2 + t) * double(out_tangent[i]) +
                        (3 * t2 - 2 * t3) * double(v1[i]) +
                        at.seconds * (t3 - t2) * double(in_tangent[i]));
}

glm::dvec4 unit_quaternion(const float* v) {
    return glm::normalize(glm::dvec4(v[0], v[1], v[2], v[3]));
}

glm::dvec4 slerp(glm::dvec4 a, glm::dvec4 b, double t) {
    double cosine = glm::dot(a, b);
    if (cosine < 0) {  // q and -q are the same rotation; take the nearer one
        b = -b;
        cosine = -cosine;
    }
    // From the chord length, which stays precise for small angles.
    const double angle = 2 * std::asin(std::min(0.5 * glm::length(b - a), 1.0));
    const double sine = std::sin(angle);
    if (sine < 1e-9) return glm::normalize(a + (b - a) * t);
    return (a * std::sin((1 - t) * angle) + b * std::sin(t * angle)) / sine;
}

template <class Number>
void interpolate(const AnimationSampler& sampler, double seconds, std::span<Number> out) {
    const Span at = find_span(sampler.times, seconds);
    const float* v0 = value_at(sampler, at.first);
    if (at.first == at.second || sampler.interpolation == Interpolation::step) {
        std::copy_n(v0, out.size(), out.begin());
    } else if (sampler.interpolation == Interpolation::cubic_spline) {
        interpolate_cubic(sampler, at, out);
    } else {
        const float* v1 = value_at(sampler, at.second);
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = Number(double(v0[i]) * (1 - at.fraction) + double(v1[i]) * at.fraction);
    }
}

}  // namespace

std::size_t AnimationSampler::width() const {
    return values.size() / times.size() / (interpolation == Interpolation::cubic_spline ? 3 : 1);
}

void evaluate(const AnimationSampler& sampler, double seconds, std::span<float> out) {
    interpolate(sampler, seconds, out);
}

void evaluate(const AnimationSampler& sampler, double seconds, std::span<double> out) {
    interpolate(sampler, seconds, out);
}

glm::dvec4 evaluate_rotation(const AnimationSampler& sampler, double seconds) {
    const Span at = find_span(sampler.times, seconds);
    if (at.first != at.second && sampler.interpolation == Interpolation::linear)
        return slerp(unit_quaternion(value_at(sampler, at.first)),
                     unit_quaternion(value_at(sampler, at.second)), at.fraction);
    std::array<float, 4> q{};
    evaluate(sampler, seconds, q);
    // A spline between opposite quaternions can pass through zero, which is not a rotation.
    if (q == std::array<float, 4>{}) return unit_quaternion(value_at(sampler, at.first));
    return unit_quaternion(q.data());
}

}  // namespace hm
