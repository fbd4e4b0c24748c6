// Reads a primitive's vertices from its attributes.
#pragma once

#include <cstdint>
#include <optional>

#include "gltf/json.h"
#include "gltf/source.h"
#include "scene/scene.h"

namespace hm::gltf {

// The accessors of one primitive; their types are valid and their counts equal.
struct Attributes {
    std::size_t position = 0;
    std::optional<std::size_t> normal;
    std::optional<std::size_t> tangent;  // only with normals
    std::optional<std::size_t> uv0;
    std::optional<std::size_t> uv1;
    bool uv1_is_read = true;  // by the material's textures; else it is not loaded
    std::optional<std::size_t> color;
    std::uint32_t count = 0;
};

// nullopt, with a warning, if there are no positions.
Result<std::optional<Attributes>> read_attributes(const Json& primitive, Source& source);

// Size of the vertices in the scene, in bytes.
std::uint64_t vertex_bytes(const Attributes& attributes);

// Fills vertices, extras, has_normals and has_tangents.
Result<void> read_vertices(const Attributes& attributes, Source& source, Primitive& primitive);

}  // namespace hm::gltf
