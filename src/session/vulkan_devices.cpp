// Implements vulkan_devices.h in a build with the Vulkan renderer.
#include "session/vulkan_devices.h"

#include <fmt/format.h>

#include <utility>

#include "gpu/bench.h"
#include "gpu/context.h"
#include "gpu/renderer.h"
#include "rhi/device.h"
#include "rhi/instance.h"

namespace hm {
namespace {

class GpuDevice final : public RenderDevice {
  public:
    explicit GpuDevice(std::unique_ptr<GpuContext> context) : context_(std::move(context)) {}

    std::string name() const override { return context_->device().physical().name + " (Vulkan)"; }
    Result<std::unique_ptr<Renderer>> load(const FlatScene& scene) override {
        HM_TRY_ASSIGN(std::unique_ptr<Renderer> renderer, VulkanRenderer::create(*context_, scene));
        return renderer;
    }
    Result<std::optional<TracedRates>> trace_rates(const FlatScene& flat,
                                                   const RenderJob& job) override {
        constexpr std::uint32_t kRepeats = 9;
        rhi::Device& device = context_->device();
        HM_TRY_ASSIGN(const std::unique_ptr<GpuScene> scene,
                      GpuScene::create(device, context_->layouts(), flat));
        TracedRates traced;
        HM_TRY_ASSIGN(traced.rates, measure_tracing(*context_, *scene, job, false, kRepeats));
        if (device.physical().has(rhi::kInvocationReorder)) {
            HM_TRY_ASSIGN(traced.reordered,
                          measure_tracing(*context_, *scene, job, true, kRepeats));
            traced.sorts = device.limits().reorders_rays;
        }
        return traced;
    }

  private:
    std::unique_ptr<GpuContext> context_;
};

VulkanDevice describe(const rhi::PhysicalDevice& physical) {
    return {.index = physical.index,
            .name = physical.name,
            .kind = rhi::kind_name(physical.kind),
            .driver = physical.driver,
            .api_version = physical.api_version,
            .is_software = physical.kind == rhi::DeviceKind::cpu,
            .memory_bytes = physical.memory_bytes,
            .capabilities = physical.capabilities};
}

}  // namespace

bool built_with_vulkan() {
    return true;
}

Result<std::vector<VulkanDevice>> list_vulkan_devices() {
    HM_TRY_ASSIGN(const std::shared_ptr<rhi::Instance> instance, rhi::Instance::create());
    HM_TRY_ASSIGN(const std::vector<rhi::PhysicalDevice> all, instance->devices());
    std::vector<VulkanDevice> devices;
    for (const rhi::PhysicalDevice& physical : all)
        devices.push_back(describe(physical));
    return devices;
}

Result<std::unique_ptr<RenderDevice>> open_vulkan_device(std::optional<std::uint32_t> index,
                                                         Diagnostics& diagnostics) {
    HM_TRY_ASSIGN(std::shared_ptr<rhi::Instance> instance, rhi::Instance::create());
    HM_TRY_ASSIGN(const std::vector<rhi::PhysicalDevice> all, instance->devices());
    HM_TRY_ASSIGN(const rhi::PhysicalDevice physical,
                  index ? rhi::choose_index(all, *index) : rhi::choose_best(all));
    HM_TRY_ASSIGN(std::unique_ptr<rhi::Device> device,
                  rhi::Device::create(std::move(instance), physical));
    HM_TRY_ASSIGN(std::unique_ptr<GpuContext> context,
                  GpuContext::create(std::move(device), rhi::default_cache_folder(), diagnostics));
    return std::make_unique<GpuDevice>(std::move(context));
}

}  // namespace hm
