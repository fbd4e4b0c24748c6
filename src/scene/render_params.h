// From settings and a scene to what the stages read: the only place that makes RenderParams.
#pragma once

#include "scene/flatten.h"
#include "shading/path_settings.h"

namespace hm {

// With default settings already a correct picture.
RenderParams make_params(const FlatScene& scene, std::uint32_t width, std::uint32_t height,
                         const PathSettings& settings = {});

// The light ranges and counts again, after params.strategy was changed.
void set_light_ranges(const FlatScene& scene, RenderParams& params);

}  // namespace hm
