// Rendering scenes on a device.
#pragma once

#include <himalaya/export.h>
#include <himalaya/picture.h>
#include <himalaya/scene.h>
#include <himalaya/settings.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace himalaya {

struct DeviceSettings {
    enum class Kind {
        automatic,  // the best GPU; the CPU if there is none or if it fails
        cpu,
        vulkan,  // no fallback
    };
    Kind kind = Kind::automatic;
    std::optional<std::uint32_t> index{};  // of a Vulkan device; none: the best
    unsigned threads = 0;                  // of the CPU; 0: all
};

struct Progress {
    double fraction = 0;  // of the samples or of the time limit
    double samples_per_pixel = 0;
    std::uint64_t rays = 0;
    double seconds = 0;  // of rendering
};

struct RenderCallbacks {
    // Called a few times a second, on a thread of the library; false cancels.
    std::function<bool(const Progress&)> progress{};
    std::stop_token stop{};
};

// A device, opened once. One thread at a time may use it.
class HIMALAYA_API Renderer {
  public:
    explicit Renderer(const DeviceSettings& settings = {});
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    std::string device() const;  // "NVIDIA H200 (Vulkan)", "CPU"
    // Why the CPU is used in place of a GPU, and warnings about the device.
    std::vector<std::string> messages() const;

    // Cancelled, it returns what was rendered until then. An exception of the progress callback
    // cancels and is passed on. A scene is used by one call at a time.
    Picture render(Scene& scene, const RenderSettings& settings = {},
                   const RenderCallbacks& callbacks = {});

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// On the device that DeviceSettings' defaults choose.
HIMALAYA_API Picture render(Scene& scene, const RenderSettings& settings = {});

}  // namespace himalaya
