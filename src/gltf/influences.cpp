#include "gltf/influences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "gltf/accessor.h"
#include "gltf/budget.h"

namespace hm::gltf {
namespace {

constexpr std::uint32_t kSetSize = 4;

struct Set {
    std::size_t joints, weights;  // accessors
};

bool is_joints(const Accessor& a) {
    return a.type == ElementType::vec4 && !a.normalized &&
           (a.component == ComponentType::uint8 || a.component == ComponentType::uint16);
}

bool is_weights(const Accessor& a) {
    const bool is_unsigned =
        a.component == ComponentType::uint8 || a.component == ComponentType::uint16;
    return a.type == ElementType::vec4 &&
           (a.component == ComponentType::float32 || (a.normalized && is_unsigned));
}

Result<std::optional<std::size_t>> find(const Json& attributes, Source& source,
                                        const std::string& key, bool (*has_type)(const Accessor&),
                                        std::uint32_t count) {
    HM_TRY_ASSIGN(const auto index, attributes.index(key, source.accessors.size(), "accessors"));
    if (!index) return std::nullopt;
    const Accessor& accessor = source.accessors[*index];
    if (!has_type(accessor))
        return attributes.invalid(
            key, fmt::format("accessor {} has a type that is invalid for this attribute", *index));
    if (accessor.count != count)
        return attributes.invalid(key, fmt::format("accessor {} has {} elements, POSITION has {}",
                                                   *index, accessor.count, count));
    check_alignment(source, *index);
    return index;
}

// Sets must be numbered from 0 without gaps.
Result<void> check_gap(const Json& attributes, std::size_t set_count) {
    std::size_t listed = 0;
    std::string_view last;
    for (const std::string_view key : attributes.keys()) {
        if (!key.starts_with("JOINTS_") && !key.starts_with("WEIGHTS_")) continue;
        ++listed;
        last = key;
    }
    if (listed == 2 * set_count) return {};
    return attributes.invalid(last,
                              "sets of joints and weights must be numbered from 0 without gaps");
}

Result<std::vector<Set>> find_sets(const Json& attributes, Source& source, std::uint32_t count) {
    std::vector<Set> sets;
    for (;;) {
        const std::string joints_key = fmt::format("JOINTS_{}", sets.size());
        const std::string weights_key = fmt::format("WEIGHTS_{}", sets.size());
        HM_TRY_ASSIGN(const auto joints, find(attributes, source, joints_key, is_joints, count));
        HM_TRY_ASSIGN(const auto weights, find(attributes, source, weights_key, is_weights, count));
        if (joints.has_value() != weights.has_value())
            return attributes.invalid(
                joints ? joints_key : weights_key,
                fmt::format("is present without {}", joints ? weights_key : joints_key));
        if (!joints) break;
        sets.push_back({*joints, *weights});
    }
    HM_TRY(check_gap(attributes, sets.size()));
    return sets;
}

// Weights slightly below zero, from rounding, become zero. Fails if one is clearly negative.
Result<void> clamp_weights(Source& source, std::size_t accessor, std::vector<float>& weights) {
    constexpr float kTolerance = 1e-3f;
    std::size_t clamped = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] < 0)) continue;
        if (weights[i] < -kTolerance)
            return fail(
                ErrorKind::invalid, source.file, accessor_pointer(accessor),
                fmt::format("element {} has the negative weight {}", i / kSetSize, weights[i]));
        weights[i] = 0;
        ++clamped;
    }
    if (clamped != 0)
        source.warn(accessor_pointer(accessor), "joint weights slightly below 0 are clamped",
                    clamped);
    return {};
}

Result<void> read_set(Source& source, const Set& set, std::size_t number,
                      const std::vector<std::uint32_t>& kept, Deformation& out) {
    HM_TRY_ASSIGN(const auto joints, read_integers(source, set.joints));
    HM_TRY_ASSIGN(auto weights, read_floats(source, set.weights));
    HM_TRY(check_finite(source, set.weights, weights));
    HM_TRY(clamp_weights(source, set.weights, weights));
    for (std::size_t v = 0; v < out.joints.size() / out.influences; ++v) {
        const std::size_t from = kSetSize * (kept.empty() ? v : kept[v]);
        const std::size_t to = v * out.influences + number * kSetSize;
        for (std::size_t i = 0; i < kSetSize; ++i) {
            out.joints[to + i] = static_cast<std::uint16_t>(joints[from + i]);
            out.weights[to + i] = weights[from + i];
        }
    }
    return {};
}

struct Flaws {
    bool sums = false, repeated = false;
};

bool repeats(std::span<const std::uint16_t> joints, std::span<const float> weights) {
    std::vector<std::uint16_t> used;
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (weights[i] != 0) used.push_back(joints[i]);
    std::sort(used.begin(), used.end());
    return std::adjacent_find(used.begin(), used.end()) != used.end();
}

// A vertex whose weights are all zero follows its first joint.
void normalize(Deformation& d, Flaws& flaws) {
    constexpr double kTolerance = 0.01;  // allows for 8-bit weights rounded individually
    for (std::size_t begin = 0; begin < d.weights.size(); begin += d.influences) {
        const std::span<float> weights(d.weights.data() + begin, d.influences);
        flaws.repeated =
            flaws.repeated || repeats({d.joints.data() + begin, d.influences}, weights);
        double sum = 0;
        for (const float w : weights)
            sum += double(w);
        flaws.sums = flaws.sums || std::abs(sum - 1) > kTolerance;
        if (sum == 0) weights[0] = 1;
        if (sum == 0 || sum == 1) continue;
        for (float& w : weights)
            w = float(double(w) / sum);
    }
}

}  // namespace

Result<void> read_influences(const Json& primitive, Source& source, std::uint32_t count,
                             const std::vector<std::uint32_t>& kept, Deformation& out) {
    HM_TRY_ASSIGN(const Json attributes,
                  primitive.required("attributes", primitive.object("attributes")));
    HM_TRY_ASSIGN(const std::vector<Set> sets, find_sets(attributes, source, count));
    if (sets.empty()) return {};
    constexpr std::uint64_t kBytes = sizeof(std::uint32_t) + sizeof(float);
    HM_TRY(take_work(primitive, source, kBytes * kSetSize * sets.size() * count));
    const std::size_t vertex_count = kept.empty() ? count : kept.size();
    out.influences = static_cast<std::uint32_t>(sets.size()) * kSetSize;
    out.joints.resize(vertex_count * out.influences);
    out.weights.resize(vertex_count * out.influences);
    HM_TRY(take_memory(primitive, source,
                       out.joints.size() * (sizeof(std::uint16_t) + sizeof(float))));
    for (std::size_t i = 0; i < sets.size(); ++i)
        HM_TRY(read_set(source, sets[i], i, kept, out));
    Flaws flaws;
    normalize(out, flaws);
    if (flaws.sums)
        source.warn(primitive.pointer(),
                    "some vertices' joint weights do not sum to one; they are normalized");
    if (flaws.repeated)
        source.warn(primitive.pointer(),
                    "some vertices list a joint more than once; its weights are added");
    return {};
}

}  // namespace hm::gltf
