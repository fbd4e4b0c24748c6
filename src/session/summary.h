// The facts about a finished picture that reports and metadata are made of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "film/renderer.h"
#include "scene/flatten.h"
#include "scene/scene.h"
#include "session/fingerprint.h"

namespace hm {

// Seconds of wall-clock time.
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
    std::uint64_t triangles = 0;  // of every instance
    std::uint64_t punctual_lights = 0, emissive_triangles = 0;
    bool paths_may_end = false;  // some surface may scatter nothing: unlit or without specular
};

struct RenderSummary {
    std::string camera, environment;
    NamedValues view;    // settings of the same view (view_of)
    float exposure = 0;  // EV, of PNG files
    SceneStats scene;
    RendererReport renderer;
    StageTimes times;
    std::uint64_t samples = 0, rays = 0, non_finite = 0;
    double samples_per_pixel = 0;                      // the mean, if an early end left differences
    double removed_luminance = 0, mean_luminance = 0;  // by the clamp, and what is left
    std::optional<double> estimated_error;             // see film/variance.h
    std::string scene_hash;
    // Blender's exporter wrote both lamps and emission, in units that may differ (LightUnits).
    bool mixes_light_units = false;
    std::string denoiser;               // empty: not denoised
    std::uint64_t replaced_pixels = 0;  // by the denoiser, not finite
    bool interrupted = false;

    double removed_share() const;  // of all luminance, by the clamp
    // Whether every camera ray missed the scene. False where that can't be told.
    bool missed_everything() const;
};

SceneStats scene_stats(const Scene& scene, const FlatScene& flat);

// The summary updated with the samples so far. `devices`: what drew them (devices_text).
RenderSummary with_samples(RenderSummary summary, const Film& film, const RenderCounters& counters,
                           double seconds, const std::string& devices);

}  // namespace hm
