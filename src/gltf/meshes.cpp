#include "gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gltf/accessor.h"
#include "gltf/attributes.h"
#include "gltf/budget.h"
#include "gltf/influences.h"
#include "gltf/morph.h"
#include "gltf/triangles.h"
#include "gltf/variants.h"
#include "scene/material_parameters.h"

namespace hm::gltf {
namespace {

std::uint64_t vertex_memory(const Primitive& primitive) {
    return primitive.vertices.size() * sizeof(Vertex) +
           primitive.extras.size() * sizeof(VertexExtra);
}

// The vertex indices; without an accessor 0, 1, 2, ...
Result<Indices> read_indices(const Json& json, Source& source, std::uint32_t vertex_count) {
    HM_TRY_ASSIGN(const auto index, json.index("indices", source.accessors.size(), "accessors"));
    if (!index) {
        Indices all(vertex_count);
        std::iota(all.each().begin(), all.each().end(), 0u);
        return all;
    }
    const Accessor& accessor = source.accessors[*index];
    const bool is_unsigned = accessor.component == ComponentType::uint8 ||
                             accessor.component == ComponentType::uint16 ||
                             accessor.component == ComponentType::uint32;
    if (accessor.type != ElementType::scalar || !is_unsigned || accessor.normalized)
        return json.invalid("indices", "indices must be unsigned integer scalars");
    if (accessor.view && source.views[*accessor.view].stride != 0)
        return json.invalid("indices",
                            fmt::format("the buffer view of accessor {} has a "
                                        "byteStride, which only vertex attributes may use",
                                        *index));
    HM_TRY(take_work(json, source, std::uint64_t{accessor.count} * sizeof(uvec3)));
    Indices indices(accessor.count);
    const std::span<std::uint32_t> each = indices.each();
    HM_TRY(read_integers_to(source, *index, {each.data(), 1}));
    // This also rejects the primitive restart value, the maximum of the index type.
    const auto past =
        std::find_if(each.begin(), each.end(), [&](std::uint32_t i) { return i >= vertex_count; });
    if (past != each.end())
        return json.invalid("indices",
                            fmt::format("index {} (element {} of accessor {}) is past the end of "
                                        "the {} vertices",
                                        *past, past - each.begin(), *index, vertex_count));
    return indices;
}

// The topology, or nullopt for points and lines.
Result<std::optional<Topology>> read_topology(const Json& json, Source& source) {
    HM_TRY_ASSIGN(const auto mode, json.integer("mode"));
    if (mode && *mode > 6) return json.invalid("mode", fmt::format("{} is not a mode", *mode));
    if (!mode) return Topology::triangles;
    if (*mode < 4) {
        source.warn(json.pointer(), "points and lines are not rendered");
        return std::nullopt;
    }
    return static_cast<Topology>(*mode);
}

// Textures read (0, 0) if the primitive has no such coordinates.
void check_texture_coordinates(const Json& json, Source& source, const Material& material,
                               const Attributes& attributes) {
    for (const MaterialTexture& texture : material_textures()) {
        const TextureSlot& slot = material.*texture.slot;
        if (slot.image == kUnset) continue;
        const bool present = (slot.uv_set == 0 ? attributes.uv0 : attributes.uv1).has_value();
        if (present) continue;
        source.warn(json.pointer(),
                    "texture coordinates that the material uses are missing; 0 is used");
        return;
    }
}

bool reads_second_coordinates(const Material& material) {
    const auto textures = material_textures();
    return std::any_of(textures.begin(), textures.end(), [&](const MaterialTexture& texture) {
        const TextureSlot& slot = material.*texture.slot;
        return slot.image != kUnset && slot.uv_set == 1;
    });
}

// Morph targets and skinning attributes. `count` and `kept` are those of read_targets.
Result<void> read_deformation(const Json& json, Source& source, std::uint32_t count,
                              const std::vector<std::uint32_t>& kept, Primitive& primitive) {
    auto deformation = std::make_shared<Deformation>();
    HM_TRY_ASSIGN(deformation->targets, read_targets(json, source, primitive, count, kept));
    HM_TRY(read_influences(json, source, count, kept, *deformation));
    if (deformation->targets.empty() && deformation->influences == 0) return {};
    HM_TRY(take_memory(json, source, vertex_memory(primitive)));
    deformation->rest = primitive.vertices;
    deformation->rest_extras = primitive.extras;
    primitive.deformation = std::move(deformation);
    return {};
}

// nullopt if the primitive has no triangles.
Result<std::optional<Primitive>> read_primitive(const Json& json, Source& source,
                                                const std::vector<Material>& materials) {
    Primitive primitive;
    HM_TRY_ASSIGN(const auto topology, read_topology(json, source));
    HM_TRY_ASSIGN(const auto material, read_material_index(json, source, materials.size()));
    HM_TRY_ASSIGN(std::optional<Attributes> attributes, read_attributes(json, source));
    if (!topology || !attributes) return std::nullopt;
    if (material) {
        primitive.material = static_cast<int>(*material);
        check_texture_coordinates(json, source, materials[*material], *attributes);
    }
    HM_TRY(take_work(json, source, vertex_bytes(*attributes)));
    attributes->uv1_is_read = material && reads_second_coordinates(materials[*material]);
    HM_TRY_ASSIGN(Indices indices, read_indices(json, source, attributes->count));
    if (topology == Topology::triangles ? indices.count % 3 != 0 : indices.count < 3)
        source.warn(json.pointer(), "the last vertices do not complete a triangle");
    primitive.triangles = make_triangles(*topology, std::move(indices));
    if (primitive.triangles.empty()) return std::nullopt;
    HM_TRY(read_vertices(*attributes, source, primitive));
    const std::vector<std::uint32_t> kept = drop_unused_vertices(primitive);
    HM_TRY(take_memory(json, source,
                       vertex_memory(primitive) + primitive.triangles.size() * sizeof(uvec3)));
    HM_TRY(read_deformation(json, source, attributes->count, kept, primitive));
    return primitive;
}

}  // namespace

Result<std::vector<Mesh>> read_meshes(const Json& root, Source& source,
                                      const std::vector<Material>& materials) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("meshes"));
    std::vector<Mesh> meshes;
    for (const Json& item : items) {
        Mesh mesh;
        HM_TRY_ASSIGN(mesh.name, name_of(item));
        HM_TRY_ASSIGN(const std::vector<Json> primitives, item.objects("primitives"));
        if (primitives.empty()) source.warn(item.pointer(), "the mesh has no primitives");
        HM_TRY_ASSIGN(const std::size_t target_count, count_targets(item, primitives));
        HM_TRY_ASSIGN(mesh.weights, read_weights(item, target_count));
        mesh.weights.resize(target_count, 0.0f);
        for (const Json& json : primitives) {
            HM_TRY_ASSIGN(std::optional<Primitive> primitive,
                          read_primitive(json, source, materials));
            if (primitive) mesh.primitives.push_back(std::move(*primitive));
        }
        meshes.push_back(std::move(mesh));
    }
    return meshes;
}

}  // namespace hm::gltf
