#include "session/metadata.h"

#include <fmt/format.h>

#include <algorithm>

#include "session/choices.h"

namespace hm {

std::string bias_text(const PathSettings& path, const RenderSummary& summary) {
    const std::string events = path.bounces == 0 ? ""
                                                 : fmt::format(" up to {} event{}", path.bounces,
                                                               path.bounces == 1 ? "" : "s");
    if (path.clamp == 0) return "unbiased" + events;
    return fmt::format("clamped at {:g}, removed {:.3g} % of luminance{}", path.clamp,
                       100 * summary.removed_share(), events.empty() ? "" : ";" + events);
}

// Apart from the seconds nothing here depends on the clock, and only what decides the bits depends
// on the machine.
Metadata picture_metadata(const RenderSettings& settings, const RenderSummary& summary,
                          const MetadataTexts& texts) {
    const PathSettings& path = settings.path;
    const bool independent = path.sampler == kSamplerIndependent;
    Metadata metadata = {
        {"software", "Himalaya " HIMALAYA_VERSION},
        {"settings", texts.settings},
        {"samplesPerPixel", fmt::format("{:g}", summary.samples_per_pixel)},
        {"seed", fmt::format("{}", path.seed)},
        {"sampler", std::string(name_of(kSamplers, path.sampler))},
        {"bounces", path.bounces == 0 ? "no limit" : fmt::format("{}", path.bounces)},
        {"bias", bias_text(path, summary)},
        {"colorSpace", "linear Rec.709"},
        {"camera", summary.camera},
        {"view", texts.view},
        {"exposure", fmt::format("{:g} EV, PNG only", summary.exposure)},
        {"environment", summary.environment},
        {"sceneHash", summary.scene_hash},
        {"device", summary.renderer.device},
        {"renderSeconds", fmt::format("{:.3f}", summary.times.render)},
        {"clamp", path.clamp == 0 ? "off" : fmt::format("{:g}", path.clamp)},
        {"clampRemovedShare", fmt::format("{:g}", summary.removed_share())}};
    if (summary.estimated_error)
        metadata.emplace_back("estimatedError", fmt::format("{:g}", *summary.estimated_error));
    const auto& aovs = settings.layers.aovs;
    if (std::find(aovs.begin(), aovs.end(), Aov::variance) != aovs.end())
        metadata.emplace_back("varianceFrom",
                              independent ? "samples" : fmt::format("{} replicates", kReplicates));
    return metadata;
}

}  // namespace hm
