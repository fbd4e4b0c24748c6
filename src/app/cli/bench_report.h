// The measurements of `himalaya bench` for one scene, and their report.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/json_writer.h"
#include "session/devices.h"

namespace hm::cli {

// One timed round of rendering.
struct Round {
    std::uint64_t samples = 0, rays = 0;
    double seconds = 0;         // wall clock
    double device_seconds = 0;  // the device's own clock; 0 where it has none
};

struct SceneRates {
    RendererReport report;
    std::uint32_t samples_per_pixel = 0;  // of a round
    Round best;
    std::optional<TracedRates> traced;
};

// Writes an object with the fields that docs/devices.md lists.
void write_scene(JsonWriter& json, const std::string& name, const SceneRates& rates);

}  // namespace hm::cli
