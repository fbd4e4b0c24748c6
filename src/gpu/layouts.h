// The layouts of the descriptor sets that bindings.glsl and the path tracer's shaders declare.
#pragma once

#include "rhi/descriptors.h"

namespace hm {

// Set 0, by bindings.glsl's numbers.
enum class SceneBinding : std::uint32_t {
    frame,
    lights,
    materials,
    instances,
    structure,
    geometry_addresses,
    geometries,
    texture_uses,
    light_alias,
    emitters,
    emitter_alias,
    environment_texels,
    environment_alias,
    sobol_nibbles,
    blue_noise,
    albedo_table,
    albedo_average,
    filter_table,
    count
};

struct SceneLayouts {
    rhi::SetLayout scene;     // set 0
    rhi::SetLayout textures;  // set 1

    static Result<SceneLayouts> create(rhi::Device& device);
};

}  // namespace hm
