// What is told about a finished picture: metadata inside the file, a JSON report, one line.
#pragma once

#include <optional>
#include <string>

#include "app/cli/options.h"
#include "base/diagnostics.h"
#include "film/renderer.h"
#include "image/write.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm::cli {

// Seconds of wall clock.
struct StageTimes {
    double load = 0;
    double flatten = 0;  // environment included
    double prepare = 0;  // upload and acceleration structure
    double render = 0;
    double denoise = 0;
    double write = 0;
};

struct SceneStats {
    std::uint64_t meshes = 0, instances = 0, materials = 0, images = 0;
    std::uint64_t triangles = 0;  // instances counted one by one
    std::uint64_t punctual_lights = 0, emissive_triangles = 0;
};

struct RenderSummary {
    std::string camera, environment;
    std::string view;    // the flags that look the same way; empty if none do
    float exposure = 0;  // EV, of PNG files
    SceneStats scene;
    RendererReport renderer;
    StageTimes times;
    std::uint64_t samples = 0, rays = 0, non_finite = 0;
    double samples_per_pixel = 0;  // the mean, where an early end left differences
    double removed_luminance = 0, mean_luminance = 0;  // by the clamp, and what is left
    std::optional<double> estimated_error;             // see film/variance.h
    std::string scene_hash;
    std::string denoiser;               // empty: nothing was denoised
    std::uint64_t replaced_pixels = 0;  // by the denoiser, not finite
    bool interrupted = false;
};

SceneStats scene_stats(const Scene& scene, const FlatScene& flat);

// The summary with what the samples so far make of it. `devices`: what drew them (devices_text).
RenderSummary with_samples(RenderSummary summary, const Film& film, const RenderCounters& counters,
                           double seconds, const std::string& devices);

Metadata picture_metadata(const RenderOptions& options, const RenderSummary& summary);
std::string json_report(const RenderOptions& options, const RenderSummary& summary,
                        const Diagnostics& diagnostics);
std::string summary_line(const RenderSummary& summary);

}  // namespace hm::cli
