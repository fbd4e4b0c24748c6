// What draws, chosen by --device: the CPU, or a GPU through Vulkan.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/cli/options.h"
#include "app/cli/values.h"
#include "film/renderer.h"
#include "gpu/trace_rates.h"
#include "scene/flatten.h"

namespace hm::cli {

Parsed<DeviceFlag> parse_device(std::string_view text);  // "auto", "cpu", "vulkan" or "vulkan:N"

// What a GPU's bench measures of one scene.
struct TracedRates {
    TraceRates rates;
    // The same with hits sorted before they are shaded, where the device offers it.
    std::optional<TraceRates> reordered;
    bool sorts = false;  // the device says that it really does, and pictures are drawn that way
};

// Opened once, for all pictures of a run.
class Device {
  public:
    virtual ~Device() = default;
    virtual std::string name() const = 0;  // for people: "NVIDIA H200 (Vulkan)"
    // Puts the scene there. Neither the device nor the scene may go before the renderer.
    virtual Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) = 0;
    // What one sample of each pixel takes by the device's clock, beside the same rays traced by
    // empty shaders; nothing where the device has no such thing.
    virtual Result<std::optional<TracedRates>> trace_rates(const FlatScene& scene,
                                                           const RenderJob& job) {
        (void)scene, (void)job;
        return std::optional<TracedRates>();
    }
};

std::unique_ptr<Device> cpu_device(unsigned threads);

using OpenVulkan = std::function<Result<std::unique_ptr<Device>>(std::optional<std::uint32_t>)>;
using Note = std::function<void(std::string_view)>;

// auto: the best GPU, or the CPU where there is none or where the GPU fails later; `note` gets one
// line about either. vulkan never falls back: it fails with ErrorKind::no_device or device_failed.
// `open_vulkan` opens the best GPU, or the device of an index.
Result<std::unique_ptr<Device>> choose_device(const DeviceFlag& wanted, unsigned threads,
                                              const OpenVulkan& open_vulkan, const Note& note);

}  // namespace hm::cli
