// A renderer that survives its device: if a GPU fails in the middle of a picture, another renderer
// takes over and no sample is lost or drawn twice.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "film/renderer.h"

namespace hm {

// No device, out of memory on it, or lost: another device can help.
bool is_device_trouble(const Error& error);

class FallbackRenderer final : public Renderer {
  public:
    // Makes the renderer that takes over, and reports the error to the user.
    using Replace = std::function<Result<std::unique_ptr<Renderer>>(const Error&)>;

    FallbackRenderer(std::unique_ptr<Renderer> first, Replace replace);

    std::string device() const override { return current_->device(); }
    Result<void> begin(const RenderJob& job, Film& film) override;
    Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                        const std::atomic<bool>& cancel) override;
    Result<void> sync() override;
    // Names both devices if both drew.
    RendererReport report() const override;

  private:
    struct Samples {
        std::uint32_t begin, end;
    };
    // What the counters said at the last sync.
    struct Counted {
        std::uint64_t samples = 0, rays = 0, non_finite = 0;
    };

    Result<void> take_over(const Error& error);
    void remember();

    std::unique_ptr<Renderer> current_;
    Replace replace_;     // empty once used
    std::string before_;  // the device whose samples the film holds, once it was replaced
    RenderJob job_;
    Film* film_ = nullptr;
    RenderCounters* counters_ = nullptr;
    const std::atomic<bool>* cancel_ = nullptr;
    std::vector<Samples> since_sync_;  // not in the film yet
    Counted counted_;
    bool film_holds_samples_ = false;
};

}  // namespace hm
