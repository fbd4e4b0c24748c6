#include "session/devices.h"

#include <fmt/format.h>

#include <utility>

#include "cpu/render.h"
#include "session/fallback.h"

namespace hm {
namespace {

class CpuDevice final : public RenderDevice {
  public:
    explicit CpuDevice(unsigned threads) : threads_(threads) {}
    std::string name() const override { return "CPU"; }
    Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) override {
        return std::make_unique<CpuRenderer>(scene, threads_);
    }

  private:
    unsigned threads_;
};

// A GPU as long as it works. Once it lacks memory for a scene or is lost, the CPU renders this and
// all later pictures.
class FallbackDevice final : public RenderDevice {
  public:
    FallbackDevice(std::unique_ptr<RenderDevice> gpu, std::unique_ptr<RenderDevice> cpu, Note note)
        : gpu_(std::move(gpu)), cpu_(std::move(cpu)), note_(std::move(note)) {}

    std::string name() const override { return gave_up_ ? cpu_->name() : gpu_->name(); }

    Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) override {
        if (gave_up_) return cpu_->load(scene);
        Result<std::unique_ptr<Renderer>> renderer = gpu_->load(scene);
        const auto replace = [this, &scene](const Error& error) {
            gave_up_ = true;
            note_(fmt::format("continuing with the CPU: {}", error.line()));
            return cpu_->load(scene);
        };
        if (renderer) return std::make_unique<FallbackRenderer>(std::move(*renderer), replace);
        if (!is_device_trouble(renderer.error())) return renderer;
        return replace(renderer.error());
    }

  private:
    std::unique_ptr<RenderDevice> gpu_, cpu_;
    Note note_;
    bool gave_up_ = false;
};

}  // namespace

std::unique_ptr<RenderDevice> cpu_device(unsigned threads) {
    return std::make_unique<CpuDevice>(threads);
}

Result<std::unique_ptr<RenderDevice>> choose_device(const DeviceChoice& wanted, unsigned threads,
                                                    const OpenVulkan& open_vulkan,
                                                    const Note& note) {
    if (wanted.kind == DeviceChoice::Kind::cpu) return cpu_device(threads);
    Result<std::unique_ptr<RenderDevice>> gpu = open_vulkan(wanted.index);
    if (gpu) note(fmt::format("drawing on {}", (*gpu)->name()));
    if (wanted.kind == DeviceChoice::Kind::vulkan) {
        return gpu;
    }
    if (gpu) return std::make_unique<FallbackDevice>(std::move(*gpu), cpu_device(threads), note);
    if (!is_device_trouble(gpu.error())) return gpu;
    note(fmt::format("drawing on the CPU: {}", gpu.error().line()));
    return cpu_device(threads);
}

}  // namespace hm
