#include "compare/flip.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/check.h"

namespace hm {
namespace {

using Planes = std::array<Plane, 3>;
using Color = std::array<float, 3>;

constexpr double kPi = std::numbers::pi;

// Linear sRGB to XYZ. The sums of the rows are the white point.
constexpr double kToXyz[3][3] = {
    {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};
constexpr double kFromXyz[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                   {-0.969224334, 1.875930071, 0.041554224},
                                   {0.055639423, -0.204011202, 1.057148933}};

Color multiply(const double (&m)[3][3], const Color& v) {
    Color out;
    for (std::size_t r = 0; r < 3; ++r)
        out[r] = float(m[r][0] * double(v[0]) + m[r][1] * double(v[1]) + m[r][2] * double(v[2]));
    return out;
}

constexpr double white(std::size_t row) {
    return kToXyz[row][0] + kToXyz[row][1] + kToXyz[row][2];
}

// XYZ relative to the white point.
Color relative_xyz(const Color& rgb) {
    Color xyz = multiply(kToXyz, rgb);
    for (std::size_t i = 0; i < 3; ++i)
        xyz[i] = float(double(xyz[i]) / white(i));
    return xyz;
}

// Linearised CIELAB, in which the spatial filters are applied.
Color to_ycxcz(const Color& rgb) {
    const Color r = relative_xyz(rgb);
    return {116.0f * r[1] - 16.0f, 500.0f * (r[0] - r[1]), 200.0f * (r[1] - r[2])};
}

Color from_ycxcz(const Color& c) {
    const double y = (double(c[0]) + 16.0) / 116.0;
    const double x = y + double(c[1]) / 500.0, z = y - double(c[2]) / 200.0;
    return multiply(kFromXyz, {float(x * white(0)), float(y * white(1)), float(z * white(2))});
}

float lab_curve(float t) {
    constexpr float kDelta = 6.0f / 29.0f;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t)
                                        : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

// CIELAB with chroma scaled by lightness (Hunt effect: dark colours appear less colourful).
Color to_hunt_lab(const Color& rgb) {
    const Color r = relative_xyz(rgb);
    const float fx = lab_curve(r[0]), fy = lab_curve(r[1]), fz = lab_curve(r[2]);
    const float lightness = 116.0f * fy - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (fx - fy),
            0.01f * lightness * 200.0f * (fy - fz)};
}

// HyAB distance (Abasi et al.), which also suits large differences.
float hyab(const Color& a, const Color& b) {
    const float da = a[1] - b[1], db = a[2] - b[2];
    return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

template <class Convert>
void convert(Planes& planes, Convert f) {
    const std::size_t width = planes[0].width;
    tbb::parallel_for(std::size_t(0), std::size_t(planes[0].height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            const Color out = f({planes[0].values[i], planes[1].values[i], planes[2].values[i]});
            for (std::size_t c = 0; c < 3; ++c)
                planes[c].values[i] = out[c];
        }
    });
}

Color clamped(const Color& c) {
    return {std::clamp(c[0], 0.0f, 1.0f), std::clamp(c[1], 0.0f, 1.0f),
            std::clamp(c[2], 0.0f, 1.0f)};
}

// A term a sqrt(pi / b) exp(-pi² x² / b) of a contrast sensitivity function, x in degrees.
struct Term {
    double a, b;
};

double sigma_px(const Term& term, double pixels_per_degree) {
    return std::sqrt(term.b / (2 * kPi * kPi)) * pixels_per_degree;
}

Plane blur(const Plane& plane, double sigma, int radius) {
    const Kernel kernel = gaussian_kernel(sigma, radius);
    return filter_columns(filter_rows(plane, kernel), kernel);
}

// Filters the three channels of YCxCz by the eye's contrast sensitivity, using spatial Gaussians.
void filter_contrast(Planes& planes, double pixels_per_degree) {
    constexpr Term kLightness{1.0, 0.0047}, kRedGreen{1.0, 0.0053};
    constexpr Term kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};
    const int radius = gaussian_radius(sigma_px(kBlueYellow[0], pixels_per_degree));
    planes[0] = blur(planes[0], sigma_px(kLightness, pixels_per_degree), radius);
    planes[1] = blur(planes[1], sigma_px(kRedGreen, pixels_per_degree), radius);

    // blur() normalises each kernel, so its integral is part of the weight of its term.
    double weights[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const double sigma = sigma_px(kBlueYellow[i], pixels_per_degree);
        double sum = 0;
        for (int x = -radius; x <= radius; ++x)
            sum += std::exp(-0.5 * x * x / (sigma * sigma));
        weights[i] = kBlueYellow[i].a * std::sqrt(kPi / kBlueYellow[i].b) * sum * sum;
    }
    const Plane wide = blur(planes[2], sigma_px(kBlueYellow[0], pixels_per_degree), radius);
    const Plane narrow = blur(planes[2], sigma_px(kBlueYellow[1], pixels_per_degree), radius);
    const auto share = float(weights[0] / (weights[0] + weights[1]));
    for (std::size_t i = 0; i < planes[2].values.size(); ++i)
        planes[2].values[i] = share * wide.values[i] + (1.0f - share) * narrow.values[i];
}

// Scales the kernel so that positive values sum to 1 and negative ones to -1.
void balance(Kernel& kernel) {
    double positive = 0, negative = 0;
    for (const float k : kernel)
        (k > 0 ? positive : negative) += double(k);
    for (float& k : kernel)
        k = float(k > 0 ? double(k) / positive : double(k) / -negative);
}

struct Features {
    Plane edges, points;  // strengths
};

Plane magnitude(const Plane& x, const Plane& y) {
    Plane out(x.width, x.height);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = std::sqrt(x.values[i] * x.values[i] + y.values[i] * y.values[i]);
    return out;
}

// Edges and points are detected by the first and second derivatives of the blurred lightness. The
// width of the blur is that of the bars that the eye detects best.
Features find_features(const Plane& ycxcz_lightness, double pixels_per_degree) {
    constexpr double kWidthDegrees = 0.082;
    const double sigma = 0.5 * kWidthDegrees * pixels_per_degree;
    const int radius = gaussian_radius(sigma);
    const Kernel smooth = gaussian_kernel(sigma, radius);
    Kernel first = smooth, second = smooth;
    for (int x = -radius; x <= radius; ++x) {
        const auto i = std::size_t(x + radius);
        first[i] *= float(-x);
        second[i] *= float(x * x / (sigma * sigma) - 1.0);
    }
    balance(first);
    balance(second);

    Plane lightness = ycxcz_lightness;
    for (float& value : lightness.values)
        value = (value + 16.0f) / 116.0f;
    const Plane smooth_rows = filter_rows(lightness, smooth);
    return {magnitude(filter_columns(filter_rows(lightness, first), smooth),
                      filter_columns(smooth_rows, first)),
            magnitude(filter_columns(filter_rows(lightness, second), smooth),
                      filter_columns(smooth_rows, second))};
}

constexpr float kColorExponent = 0.7f;

// Compresses large differences: 0.4 of the largest one maps to 0.95.
float color_error(float distance) {
    static const float largest =
        std::pow(hyab(to_hunt_lab({0, 1, 0}), to_hunt_lab({0, 0, 1})), kColorExponent);
    constexpr float kKnee = 0.4f, kAtKnee = 0.95f;
    const float error = std::pow(distance, kColorExponent), knee = kKnee * largest;
    if (error < knee) return error * kAtKnee / knee;
    return kAtKnee + (error - knee) / (largest - knee) * (1.0f - kAtKnee);
}

float feature_error(const Features& reference, const Features& test, std::size_t i) {
    const float edges = std::abs(reference.edges.values[i] - test.edges.values[i]);
    const float points = std::abs(reference.points.values[i] - test.points.values[i]);
    return std::sqrt(std::max(edges, points) * float(1.0 / std::numbers::sqrt2));
}

struct Perceived {
    Features features;
    Planes lab;
};

// The picture as perceived: filtered colours and detected features.
Perceived perceive(Planes rgb, double pixels_per_degree) {
    convert(rgb, [](const Color& c) { return to_ycxcz(clamped(c)); });
    Perceived perceived;
    perceived.features = find_features(rgb[0], pixels_per_degree);
    filter_contrast(rgb, pixels_per_degree);
    convert(rgb, [](const Color& c) { return to_hunt_lab(clamped(from_ycxcz(c))); });
    perceived.lab = std::move(rgb);
    return perceived;
}

Plane flip_of_planes(Planes reference, Planes test, double pixels_per_degree) {
    const Perceived a = perceive(std::move(reference), pixels_per_degree);
    const Perceived b = perceive(std::move(test), pixels_per_degree);
    Plane error(a.lab[0].width, a.lab[0].height);
    const std::size_t width = error.width;
    tbb::parallel_for(std::size_t(0), std::size_t(error.height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            const float distance =
                hyab({a.lab[0].values[i], a.lab[1].values[i], a.lab[2].values[i]},
                     {b.lab[0].values[i], b.lab[1].values[i], b.lab[2].values[i]});
            error.values[i] =
                std::pow(color_error(distance), 1.0f - feature_error(a.features, b.features, i));
        }
    });
    return error;
}

// Coefficients of Narkowicz' rational fit of the ACES curve, multiplied by the powers of the
// exposure 0.6 that the fit assumes.
struct Aces {
    static constexpr double a = 0.6 * 0.6 * 2.51, b = 0.6 * 0.03, c = 0.0;
    static constexpr double d = 0.6 * 0.6 * 2.43, e = 0.6 * 0.59, f = 0.14;
};

Color tone_mapped(const Color& radiance, float scale) {
    Color out;
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = double(std::max(radiance[i], 0.0f) * scale);
        out[i] = float(((Aces::a * x + Aces::b) * x + Aces::c) /
                       ((Aces::d * x + Aces::e) * x + Aces::f));
    }
    return clamped(out);
}

// The radiance that the curve maps to `shown`.
double aces_inverse(double shown) {
    const double a = Aces::a - shown * Aces::d, b = Aces::b - shown * Aces::e;
    const double c = Aces::c - shown * Aces::f;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

// The range starts at the exposure that maps the brightest pixel to just below saturation and stops
// at the one that does so for the median.
void choose_exposures(const Planes& reference, HdrFlip& result) {
    constexpr double kNearlySaturated = 0.85;
    std::vector<float> luminances;
    luminances.reserve(reference[0].values.size());
    for (std::size_t i = 0; i < reference[0].values.size(); ++i)
        luminances.push_back(0.2126f * reference[0].values[i] + 0.7152f * reference[1].values[i] +
                             0.0722f * reference[2].values[i]);
    const auto middle = luminances.begin() + std::ptrdiff_t(luminances.size() / 2);
    std::nth_element(luminances.begin(), middle, luminances.end());
    const double median = double(*middle);
    const double brightest = double(*std::max_element(middle, luminances.end()));
    // Keeps the exposures of a black reference finite.
    constexpr double kFloor = double(std::numeric_limits<float>::epsilon());
    const double level = aces_inverse(kNearlySaturated);
    result.start_exposure = std::log2(level / std::max(brightest, kFloor));
    result.stop_exposure = std::log2(level / std::max(median, kFloor));
    result.exposures =
        std::uint32_t(std::max(2.0, std::ceil(result.stop_exposure - result.start_exposure)));
}

void check_pair(const FloatImage& a, const FloatImage& b) {
    HM_CHECK(a.width == b.width && a.height == b.height && a.width > 0 && a.height > 0,
             "{} x {} and {} x {} pixels", a.width, a.height, b.width, b.height);
}

}  // namespace

Plane ldr_flip(const FloatImage& reference, const FloatImage& test, double pixels_per_degree) {
    check_pair(reference, test);
    return flip_of_planes(color_planes(reference), color_planes(test), pixels_per_degree);
}

HdrFlip hdr_flip(const FloatImage& reference, const FloatImage& test, double pixels_per_degree) {
    check_pair(reference, test);
    const Planes a = color_planes(reference), b = color_planes(test);
    HdrFlip result;
    result.error = Plane(reference.width, reference.height);
    choose_exposures(a, result);
    const double step =
        (result.stop_exposure - result.start_exposure) / double(result.exposures - 1);
    for (std::uint32_t n = 0; n < result.exposures; ++n) {
        const auto scale = float(std::exp2(result.start_exposure + n * step));
        const auto expose = [scale](const Color& c) { return tone_mapped(c, scale); };
        Planes shown_a = a, shown_b = b;
        convert(shown_a, expose);
        convert(shown_b, expose);
        const Plane error =
            flip_of_planes(std::move(shown_a), std::move(shown_b), pixels_per_degree);
        for (std::size_t i = 0; i < error.values.size(); ++i)
            result.error.values[i] = std::max(result.error.values[i], error.values[i]);
    }
    return result;
}

}  // namespace hm
