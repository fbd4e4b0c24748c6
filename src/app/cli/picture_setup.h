// One picture before it is on a device: its scene posed and flattened, and looked at by its camera.
#pragma once

#include "app/cli/aovs.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "app/cli/setup.h"
#include "film/renderer.h"
#include "scene/flatten.h"

namespace hm::cli {

struct PictureSetup {
    FlatScene flat;  // points into the scene
    RenderJob job;
    AovSetup aovs;
    RenderSummary summary;  // with what is known by then
};

// Leaves the scene posed, and takes the environment's map: it is flat.environment from then on.
Result<PictureSetup> set_up_picture(const RenderOptions& options, Scene& scene,
                                    EnvironmentChoice& environment, Diagnostics& diagnostics);

}  // namespace hm::cli
