// What `himalaya bench` measures of a scene, and says of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/json_writer.h"
#include "session/devices.h"

namespace hm::cli {

// A stretch of drawing.
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

// An object of docs/devices.md's fields.
void write_scene(JsonWriter& json, const std::string& name, const SceneRates& rates);

}  // namespace hm::cli
