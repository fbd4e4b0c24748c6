// From the options and the scene to what the renderer is told.
#pragma once

#include <string>

#include "app/cli/options.h"
#include "scene/environment.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm::cli {

struct EnvironmentChoice {
    EnvironmentMap map;
    std::string name;  // the file, "none" or "default"
    std::string hash;  // of the file's bytes (base/hash.h), else empty
};

// The file that --env names, darkness, or the default sky where no punctual light is used.
Result<EnvironmentChoice> choose_environment(const RenderOptions& options, const Scene& scene);

struct CameraChoice {
    CameraData data{};
    std::string name;  // "camera 0 (name)", "look-at" or "framing"
};

// The flags that give this view again; empty for an orthographic camera, which has none.
std::string view_flags(const CameraData& camera);

// Fails with ErrorKind::invalid_argument where the flags do not fit the scene. `world` has the
// nodes' transforms where they are not those of the scene's own pose.
Result<CameraChoice> choose_camera(const ViewOptions& view, const Scene& scene,
                                   const Bounds& bounds, float aspect);
Result<CameraChoice> choose_camera(const ViewOptions& view, const Scene& scene,
                                   const std::vector<glm::mat4>& world, const Bounds& bounds,
                                   float aspect);

RenderParams make_params(const RenderOptions& options, const FlatScene& scene);

}  // namespace hm::cli
