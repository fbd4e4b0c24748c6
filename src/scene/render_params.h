// Builds the RenderParams that the stages read from settings and a scene; the only place that does.
#pragma once

#include "scene/flatten.h"
#include "shading/path_settings.h"

namespace hm {

// The default settings already give a correct image.
RenderParams make_params(const FlatScene& scene, std::uint32_t width, std::uint32_t height,
                         const PathSettings& settings = {});

// Recomputes the light ranges and counts after a change of params.strategy.
void set_light_ranges(const FlatScene& scene, RenderParams& params);

}  // namespace hm
