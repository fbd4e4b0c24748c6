// A scene file with everything that a renderer needs of it.
#pragma once

#include <filesystem>
#include <memory>

#include "gltf/load.h"
#include "session/picture_setup.h"

namespace hm {

struct PreparedScene {
    Scene scene;
    PictureSetup setup;  // points into `scene`
};

Result<std::unique_ptr<PreparedScene>> prepare_scene(const std::filesystem::path& file,
                                                     const LoadOptions& load,
                                                     const RenderSettings& settings,
                                                     Diagnostics& diagnostics);

}  // namespace hm
