// One picture before it is on a device: its scene posed and flattened, its camera, and the job that
// a renderer gets.
#pragma once

#include "base/diagnostics.h"
#include "film/renderer.h"
#include "scene/flatten.h"
#include "session/aovs.h"
#include "session/environment_choice.h"
#include "session/settings.h"
#include "session/summary.h"

namespace hm {

struct PictureSetup {
    FlatScene flat;  // points into the scene
    RenderJob job;
    AovSetup aovs;
    RenderSummary summary;  // what is known at this point
};

// Leaves the scene posed, and takes the environment's map: it is flat.environment from then on.
Result<PictureSetup> set_up_picture(const RenderSettings& settings, Scene& scene,
                                    EnvironmentChoice& environment, Diagnostics& diagnostics);

}  // namespace hm
