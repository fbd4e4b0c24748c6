#include "app/cli/devices.h"

#include <fmt/format.h>

#include <utility>

#include "app/cli/fallback.h"
#include "cpu/render.h"

namespace hm::cli {
namespace {

class CpuDevice final : public Device {
  public:
    explicit CpuDevice(unsigned threads) : threads_(threads) {}
    std::string name() const override { return "CPU"; }
    Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) override {
        return std::make_unique<CpuRenderer>(scene, threads_);
    }

  private:
    unsigned threads_;
};

// A GPU as long as it works. Where it has not enough memory for a scene, or is lost, this and all
// later pictures are the CPU's.
class FallbackDevice final : public Device {
  public:
    FallbackDevice(std::unique_ptr<Device> gpu, std::unique_ptr<Device> cpu, Note note)
        : gpu_(std::move(gpu)), cpu_(std::move(cpu)), note_(std::move(note)) {}

    std::string name() const override { return gave_up_ ? cpu_->name() : gpu_->name(); }

    Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) override {
        if (gave_up_) return cpu_->load(scene);
        Result<std::unique_ptr<Renderer>> renderer = gpu_->load(scene);
        const auto replace = [this, &scene](const Error& error) {
            gave_up_ = true;
            note_(fmt::format("going on with the CPU: {}", error.line()));
            return cpu_->load(scene);
        };
        if (renderer) return std::make_unique<FallbackRenderer>(std::move(*renderer), replace);
        if (!is_device_trouble(renderer.error())) return renderer;
        return replace(renderer.error());
    }

  private:
    std::unique_ptr<Device> gpu_, cpu_;
    Note note_;
    bool gave_up_ = false;
};

}  // namespace

Parsed<DeviceFlag> parse_device(std::string_view text) {
    if (text == "auto") return DeviceFlag{DeviceFlag::Kind::automatic, {}};
    if (text == "cpu") return DeviceFlag{DeviceFlag::Kind::cpu, {}};
    if (text == "vulkan") return DeviceFlag{DeviceFlag::Kind::vulkan, {}};
    constexpr std::string_view kIndexed = "vulkan:";
    if (text.starts_with(kIndexed)) {
        const Parsed<std::uint32_t> index = parse_integer(text.substr(kIndexed.size()), 0, 9999);
        if (index) return DeviceFlag{DeviceFlag::Kind::vulkan, *index};
    }
    return tl::unexpected(fmt::format("\"{}\" is none of auto, cpu, vulkan, vulkan:N", text));
}

std::unique_ptr<Device> cpu_device(unsigned threads) {
    return std::make_unique<CpuDevice>(threads);
}

Result<std::unique_ptr<Device>> choose_device(const DeviceFlag& wanted, unsigned threads,
                                              const OpenVulkan& open_vulkan, const Note& note) {
    if (wanted.kind == DeviceFlag::Kind::cpu) return cpu_device(threads);
    Result<std::unique_ptr<Device>> gpu = open_vulkan(wanted.index);
    if (gpu) note(fmt::format("drawing on {}", (*gpu)->name()));
    if (wanted.kind == DeviceFlag::Kind::vulkan) {
        if (!gpu) gpu.error().message += "; `himalaya doctor` says what to do";
        return gpu;
    }
    if (gpu) return std::make_unique<FallbackDevice>(std::move(*gpu), cpu_device(threads), note);
    if (!is_device_trouble(gpu.error())) return gpu;
    note(fmt::format("drawing on the CPU: {}", gpu.error().line()));
    return cpu_device(threads);
}

}  // namespace hm::cli
