#include "gltf/morph.h"

#include <fmt/format.h>

#include "gltf/accessor.h"
#include "gltf/budget.h"

namespace hm::gltf {
namespace {

using Kept = std::vector<std::uint32_t>;

// Which integers a delta may use in place of floats.
enum class Encoding { position, direction, other };

struct TargetReader {
    const Json& target;
    const Json& base;  // the primitive's attributes
    Source& source;
    std::uint32_t count;
    const Kept& kept;

    Result<std::optional<std::size_t>> find(std::string_view key, ElementType type,
                                            Encoding encoding);

    // Appends the nonzero deltas. T may have more components than the accessor; they become zero.
    template <class T>
    Result<void> read(std::string_view key, ElementType type, Encoding encoding,
                      std::vector<Delta<T>>& out);
};

// KHR_mesh_quantization adds signed integers for positions and directions (table in its section
// "Extending Morph Target Attributes").
bool is_encoded(const Accessor& accessor, Encoding use, bool quantized) {
    const bool is_signed =
        accessor.component == ComponentType::int8 || accessor.component == ComponentType::int16;
    switch (use) {
        case Encoding::position:
            return quantized && is_signed;
        case Encoding::direction:
            return quantized && is_signed && accessor.normalized;
        case Encoding::other:
            return accessor.normalized;  // 8 or 16 bits, ensured by read_accessors
    }
    return false;
}

bool has_type(const Accessor& accessor, std::string_view key, ElementType type, Encoding encoding,
              bool quantized) {
    const bool is_color = key.starts_with("COLOR_") && accessor.type == ElementType::vec3;
    if (accessor.type != type && !is_color) return false;
    return accessor.component == ComponentType::float32 ||
           is_encoded(accessor, encoding, quantized);
}

// An attribute's accessor, checked against that of the primitive.
Result<std::optional<std::size_t>> TargetReader::find(std::string_view key, ElementType type,
                                                      Encoding encoding) {
    HM_TRY_ASSIGN(const auto& index, target.index(key, source.accessors.size(), "accessors"));
    if (!index) return std::nullopt;
    if (!base.has(key)) return target.invalid(key, "the primitive does not have this attribute");
    const Accessor& accessor = source.accessors[*index];
    if (!has_type(accessor, key, type, encoding, source.quantized))
        return target.invalid(
            key, fmt::format("accessor {} has a type that is invalid for this delta", *index));
    if (accessor.count != count)
        return target.invalid(key, fmt::format("accessor {} has {} elements, POSITION has {}",
                                               *index, accessor.count, count));
    check_alignment(source, *index);
    return index;
}

template <class T>
Result<void> TargetReader::read(std::string_view key, ElementType type, Encoding encoding,
                                std::vector<Delta<T>>& out) {
    HM_TRY_ASSIGN(const auto& index, find(key, type, encoding));
    if (!index) return {};
    HM_TRY(take_work(target, source, std::uint64_t{count} * (sizeof(T) + sizeof(Delta<T>))));
    HM_TRY_ASSIGN(const std::vector<float> values, read_floats(source, *index));
    HM_TRY(check_finite(source, *index, values));
    if (encoding == Encoding::position)
        check_limits(source, *index, {values.data(), component_count(type)});
    const std::size_t width = component_count(source.accessors[*index].type);
    const std::size_t vertex_count = kept.empty() ? count : kept.size();
    for (std::size_t i = 0; i < vertex_count; ++i) {
        const float* from = values.data() + width * (kept.empty() ? i : kept[i]);
        T delta(0);
        for (std::size_t c = 0; c < width; ++c)
            delta[glm::length_t(c)] = from[c];
        if (delta != T(0)) out.push_back({static_cast<std::uint32_t>(i), delta});
    }
    out.shrink_to_fit();
    return take_memory(target, source, out.size() * sizeof(Delta<T>));
}

Result<MorphTarget> read_target(TargetReader& reader, const Primitive& primitive) {
    MorphTarget out;
    HM_TRY(reader.read("POSITION", ElementType::vec3, Encoding::position, out.positions));
    HM_TRY(reader.read("NORMAL", ElementType::vec3, Encoding::direction, out.normals));
    HM_TRY(reader.read("TANGENT", ElementType::vec3, Encoding::direction, out.tangents));
    HM_TRY(reader.read("TEXCOORD_0", ElementType::vec2, Encoding::other, out.uv0));
    HM_TRY(reader.read("TEXCOORD_1", ElementType::vec2, Encoding::other, out.uv1));
    HM_TRY(reader.read("COLOR_0", ElementType::vec4, Encoding::other, out.colors));
    if (!primitive.has_tangents) out.tangents.clear();
    if (primitive.extras.empty()) out.uv1.clear();  // nothing reads them
    return out;
}

}  // namespace

Result<std::size_t> count_targets(const Json& mesh, const std::vector<Json>& primitives) {
    std::optional<std::size_t> all;
    for (const Json& primitive : primitives) {
        HM_TRY_ASSIGN(const std::vector<Json> targets, primitive.objects("targets"));
        if (all && *all != targets.size())
            return mesh.invalid(
                "primitives",
                fmt::format("one has {} morph targets, another has {}", *all, targets.size()));
        all = targets.size();
    }
    return all.value_or(0);
}

Result<std::vector<float>> read_weights(const Json& owner, std::size_t target_count) {
    if (!owner.has("weights")) return std::vector<float>();
    HM_TRY_ASSIGN(std::vector<float> weights, owner.number_list("weights"));
    if (weights.size() != target_count)
        return owner.invalid("weights", fmt::format("{} weights for {} morph targets",
                                                    weights.size(), target_count));
    return weights;
}

Result<std::vector<MorphTarget>> read_targets(const Json& json, Source& source,
                                              const Primitive& primitive, std::uint32_t count,
                                              const std::vector<std::uint32_t>& kept) {
    std::vector<MorphTarget> out;
    HM_TRY_ASSIGN(const std::vector<Json> targets, json.objects("targets"));
    if (targets.empty()) return out;
    HM_TRY_ASSIGN(const Json base, json.required("attributes", json.object("attributes")));
    HM_TRY(take_memory(json, source, targets.size() * sizeof(MorphTarget)));
    for (const Json& target : targets) {
        TargetReader reader{target, base, source, count, kept};
        HM_TRY_ASSIGN(MorphTarget read, read_target(reader, primitive));
        out.push_back(std::move(read));
    }
    return out;
}

}  // namespace hm::gltf
