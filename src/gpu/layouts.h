// The layouts of the descriptor sets that bindings.glsl declares.
#pragma once

#include "rhi/descriptors.h"

namespace hm {

struct SceneLayouts {
    rhi::SetLayout scene;     // set 0: bindings 0, 1, ... of gpu/tables.h and the shared tables
    rhi::SetLayout textures;  // set 1

    static Result<SceneLayouts> create(rhi::Device& device);
};

}  // namespace hm
