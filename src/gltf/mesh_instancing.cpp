#include "gltf/mesh_instancing.h"

#include <fmt/format.h>

#include "gltf/accessor.h"
#include "gltf/budget.h"
#include "scene/transform.h"

namespace hm::gltf {
namespace {

struct Columns {
    std::vector<float> translation, rotation, scale;  // empty if absent
    std::size_t count = 0;
};

bool has_type(const Accessor& accessor, ElementType type) {
    if (accessor.type != type) return false;
    if (accessor.component == ComponentType::float32) return true;
    const bool is_signed =
        accessor.component == ComponentType::int8 || accessor.component == ComponentType::int16;
    return type == ElementType::vec4 && is_signed && accessor.normalized;
}

Result<std::vector<float>> read_column(const Json& attributes, Source& source, std::string_view key,
                                       ElementType type, std::size_t& count) {
    HM_TRY_ASSIGN(const auto index, attributes.index(key, source.accessors.size(), "accessors"));
    if (!index) return std::vector<float>();
    const Accessor& accessor = source.accessors[*index];
    if (!has_type(accessor, type))
        return attributes.invalid(
            key, fmt::format("accessor {} has a type that is invalid for this attribute", *index));
    if (count != 0 && accessor.count != count)
        return attributes.invalid(key, fmt::format("accessor {} has {} elements, another has {}",
                                                   *index, accessor.count, count));
    count = accessor.count;
    HM_TRY(take_work(attributes, source,
                     std::uint64_t{accessor.count} * component_count(type) * sizeof(float)));
    HM_TRY_ASSIGN(std::vector<float> values, read_floats(source, *index));
    HM_TRY(check_finite(source, *index, values));
    return values;
}

// Fails if a rotation is a zero quaternion.
Result<std::vector<glm::mat4>> make_transforms(const Json& attributes, const Columns& columns) {
    std::vector<glm::mat4> out;
    out.reserve(columns.count);
    for (std::size_t i = 0; i < columns.count; ++i) {
        Transform t;
        for (std::size_t c = 0; c < 3; ++c) {
            if (!columns.translation.empty())
                t.translation[c] = double(columns.translation[3 * i + c]);
            if (!columns.scale.empty()) t.scale[c] = double(columns.scale[3 * i + c]);
        }
        for (std::size_t c = 0; c < 4 && !columns.rotation.empty(); ++c)
            t.rotation[c] = double(columns.rotation[4 * i + c]);
        if (t.rotation == glm::dvec4(0))
            return attributes.invalid("ROTATION",
                                      fmt::format("element {} is a zero quaternion", i));
        out.emplace_back(to_matrix(t));
    }
    return out;
}

}  // namespace

Result<std::vector<glm::mat4>> read_instances(const Json& node, Source& source) {
    HM_TRY_ASSIGN(const auto extension, extension_of(node, "EXT_mesh_gpu_instancing"));
    if (!extension) return std::vector<glm::mat4>();
    HM_TRY_ASSIGN(const Json attributes,
                  extension->required("attributes", extension->object("attributes")));
    Columns columns;
    const auto read = [&](std::string_view key, ElementType type) {
        return read_column(attributes, source, key, type, columns.count);
    };
    HM_TRY_ASSIGN(columns.translation, read("TRANSLATION", ElementType::vec3));
    HM_TRY_ASSIGN(columns.rotation, read("ROTATION", ElementType::vec4));
    HM_TRY_ASSIGN(columns.scale, read("SCALE", ElementType::vec3));
    if (columns.count == 0) return attributes.invalid("", "has no TRANSLATION, ROTATION or SCALE");
    // Written by three.js and Babylon.js; the extension leaves other attributes to applications.
    if (attributes.has("_COLOR_0"))
        source.warn(attributes.pointer_of("_COLOR_0"),
                    "colours of instances are not read; all have the mesh's own");
    constexpr std::uint64_t kBytes = sizeof(glm::mat4) + sizeof(InstanceData);
    HM_TRY(take_memory(attributes, source, kBytes * columns.count));
    return make_transforms(attributes, columns);
}

}  // namespace hm::gltf
