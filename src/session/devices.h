// The device that renders: the CPU, or a GPU through Vulkan.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "film/renderer.h"
#include "gpu/trace_rates.h"
#include "scene/flatten.h"
#include "session/settings.h"

namespace hm {

// What a GPU's benchmark measures with one scene.
struct TracedRates {
    TraceRates rates;
    // The same with hits reordered before shading, if the device supports it.
    std::optional<TraceRates> reordered;
    bool sorts = false;  // the device reports that it really does, and pictures are rendered so
};

// Opened once, for all pictures of a session.
class RenderDevice {
  public:
    virtual ~RenderDevice() = default;
    virtual std::string name() const = 0;  // for people: "NVIDIA H200 (Vulkan)"
    // Uploads the scene. Device and scene must outlive the renderer.
    virtual Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) = 0;
    // The time of one sample per pixel by the device's clock, beside the same rays traced by empty
    // shaders; empty if the device can't measure that.
    virtual Result<std::optional<TracedRates>> trace_rates(const FlatScene& scene,
                                                           const RenderJob& job) {
        (void)scene, (void)job;
        return std::optional<TracedRates>();
    }
};

std::unique_ptr<RenderDevice> cpu_device(unsigned threads);

using OpenVulkan =
    std::function<Result<std::unique_ptr<RenderDevice>>(std::optional<std::uint32_t>)>;
using Note = std::function<void(std::string_view)>;

// automatic: the best GPU, or the CPU if there is none or if the GPU fails later; `note` gets one
// line about either. vulkan never falls back: it fails with ErrorKind::no_device or device_failed.
// `open_vulkan` opens the best GPU, or the device with an index.
Result<std::unique_ptr<RenderDevice>> choose_device(const DeviceChoice& wanted, unsigned threads,
                                                    const OpenVulkan& open_vulkan,
                                                    const Note& note);

}  // namespace hm
