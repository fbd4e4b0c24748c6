#include "gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gltf/accessor.h"
#include "gltf/attributes.h"
#include "gltf/materials.h"
#include "gltf/triangles.h"

namespace hm::gltf {
namespace {

// Takes what decoding this primitive will need from the budget, before memory is.
Result<void> take_work(const Json& json, Source& source, std::uint64_t bytes) {
    if (bytes > source.budget.kept_bytes || bytes > source.budget.decoded_bytes)
        return json.invalid("", "the file's meshes decode to too much data for its size");
    source.budget.decoded_bytes -= bytes;
    return {};
}

Result<void> take_memory(const Json& json, Source& source, const Primitive& primitive) {
    const std::uint64_t bytes = primitive.vertices.size() * sizeof(Vertex) +
                                primitive.extras.size() * sizeof(VertexExtra) +
                                primitive.triangles.size() * sizeof(uvec3);
    if (bytes > source.budget.kept_bytes)
        return json.invalid("", "the file's meshes decode to too much data for its size");
    source.budget.kept_bytes -= bytes;
    return {};
}

// The vertices in drawing order; without an accessor simply all of them.
Result<std::vector<std::uint32_t>> read_indices(const Json& json, Source& source,
                                                std::uint32_t vertex_count) {
    HM_TRY_ASSIGN(const auto index, json.index("indices", source.accessors.size(), "accessors"));
    if (!index) {
        std::vector<std::uint32_t> all(vertex_count);
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }
    const Accessor& accessor = source.accessors[*index];
    const bool is_unsigned = accessor.component == ComponentType::uint8 ||
                             accessor.component == ComponentType::uint16 ||
                             accessor.component == ComponentType::uint32;
    if (accessor.type != ElementType::scalar || !is_unsigned || accessor.normalized)
        return json.invalid("indices", "indices are scalars of unsigned integers");
    HM_TRY(take_work(json, source, std::uint64_t{accessor.count} * sizeof(uvec3)));
    HM_TRY_ASSIGN(std::vector<std::uint32_t> indices, read_integers(source, *index));
    // The primitive restart value is the type's largest, which no vertex may have: refused here
    // too.
    const auto past = std::find_if(indices.begin(), indices.end(),
                                   [&](std::uint32_t i) { return i >= vertex_count; });
    if (past != indices.end())
        return json.invalid("indices",
                            fmt::format("index {} (element {} of accessor {}) is past the end of "
                                        "the {} vertices",
                                        *past, past - indices.begin(), *index, vertex_count));
    return indices;
}

// The topology, or nothing for points and lines.
Result<std::optional<Topology>> read_topology(const Json& json, Source& source) {
    HM_TRY_ASSIGN(const auto mode, json.integer("mode"));
    if (mode && *mode > 6) return json.invalid("mode", fmt::format("{} is no mode", *mode));
    if (!mode) return Topology::triangles;
    if (*mode < 4) {
        source.warn(json.place(), "points and lines are not drawn");
        return std::nullopt;
    }
    return static_cast<Topology>(*mode);
}

// A textured material reads zeros where the primitive lacks the coordinates.
void check_texture_coordinates(const Json& json, Source& source, const Material& material,
                               const Attributes& attributes) {
    for (const TextureSlot* slot : texture_slots(material)) {
        if (slot->image == kUnset) continue;
        const bool present = (slot->uv_set == 0 ? attributes.uv0 : attributes.uv1).has_value();
        if (present) continue;
        source.warn(json.place(),
                    "the material's textures need coordinates that are missing; "
                    "zero is used");
        return;
    }
}

// Nothing for what makes no triangles.
Result<std::optional<Primitive>> read_primitive(const Json& json, Source& source,
                                                const std::vector<Material>& materials) {
    Primitive primitive;
    HM_TRY_ASSIGN(const auto topology, read_topology(json, source));
    HM_TRY_ASSIGN(const auto material, json.index("material", materials.size(), "materials"));
    HM_TRY_ASSIGN(const std::optional<Attributes> attributes, read_attributes(json, source));
    if (!topology || !attributes) return std::nullopt;
    if (material) {
        primitive.material = static_cast<int>(*material);
        check_texture_coordinates(json, source, materials[*material], *attributes);
    }
    HM_TRY(take_work(json, source, vertex_bytes(*attributes)));
    HM_TRY_ASSIGN(const auto indices, read_indices(json, source, attributes->count));
    if (topology == Topology::triangles ? indices.size() % 3 != 0 : indices.size() < 3)
        source.warn(json.place(), "vertices left over that complete no triangle");
    primitive.triangles = make_triangles(*topology, indices);
    if (primitive.triangles.empty()) return std::nullopt;
    HM_TRY(read_vertices(*attributes, source, primitive));
    drop_unused_vertices(primitive);
    HM_TRY(take_memory(json, source, primitive));
    return primitive;
}

}  // namespace

Result<std::vector<Mesh>> read_meshes(const Json& root, Source& source,
                                      const std::vector<Material>& materials) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("meshes"));
    std::vector<Mesh> meshes;
    std::size_t morphed = 0;
    for (const Json& item : items) {
        Mesh mesh;
        HM_TRY_ASSIGN(mesh.name, item.name());
        HM_TRY_ASSIGN(const std::vector<Json> primitives, item.objects("primitives"));
        if (primitives.empty()) source.warn(item.place(), "a mesh without primitives");
        bool has_targets = false;
        for (const Json& json : primitives) {
            HM_TRY_ASSIGN(std::optional<Primitive> primitive,
                          read_primitive(json, source, materials));
            if (primitive) mesh.primitives.push_back(std::move(*primitive));
            has_targets = has_targets || json.has("targets");
        }
        if (has_targets) ++morphed;
        meshes.push_back(std::move(mesh));
    }
    if (morphed > 0)
        source.warn("/meshes", fmt::format("meshes with morph targets: {}; they stay at rest, "
                                           "morphing is not supported",
                                           morphed));
    return meshes;
}

}  // namespace hm::gltf
