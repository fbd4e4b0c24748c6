// One picture of a session, from its scene to its samples: set up, put on a device, resumed from a
// checkpoint, rendered in passes.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "session/devices.h"
#include "session/keeper.h"
#include "session/metadata.h"
#include "session/picture_setup.h"

namespace hm {

// What the pictures of a session share.
struct Stage {
    RenderDevice& device;
    Scene& scene;
    SceneFingerprint fingerprint;  // the scene's part; the environment's is filled in
    double load_seconds = 0;       // reported with the first picture
    std::optional<EnvironmentChoice> environment{};  // chosen with the first picture
    std::optional<Checkpoint> resumed{};             // the first picture's
};

struct DrawHooks {
    std::function<bool()> stop;                            // whether to stop after this pass
    std::function<void(const ProgressState&)> watch;       // a few times a second, on a thread
    std::function<void(std::string_view)> warn;            // about checkpoints not written
    std::function<void(const RenderSummary&)> prepared{};  // before the scene goes to the device
    std::function<MetadataTexts(const RenderSummary&)> describe{};
};

struct DrawnPicture {
    Film film;
    FilmRecord record;
    RenderSummary summary;
    Result<void> kept;              // whether the last checkpoint was written
    std::optional<Error> failed{};  // why the device gave up after some samples
};

// Fails if nothing was drawn because of an error; stopped early, it returns what there is, perhaps
// no sample.
Result<DrawnPicture> draw_picture(const RenderSettings& settings, const KeepSettings& keep,
                                  Stage& stage, const DrawHooks& hooks, Diagnostics& diagnostics);

}  // namespace hm
