// A scene with all that a renderer is told of it, for commands that draw with their own settings.
#pragma once

#include <memory>

#include "app/cli/options.h"
#include "film/renderer.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm::cli {

struct PreparedScene {
    Scene scene;
    FlatScene flat;  // points into `scene`
    RenderJob job;
};

// In its rest pose.
Result<std::unique_ptr<PreparedScene>> prepare_scene(const RenderOptions& options,
                                                     Diagnostics& diagnostics);

}  // namespace hm::cli
