#include "rhi/pipeline.h"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "base/check.h"
#include "rhi/error.h"
#include "rhi/pipeline_cache.h"

namespace hm::rhi {

Result<ShaderModule> make_shader_module(Device& device, std::string_view name, Spirv spirv) {
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = spirv.size_bytes(),
                                        .pCode = spirv.data()};
    VkShaderModule handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateShaderModule(device.handle(), &info, nullptr, &handle),
                        "vkCreateShaderModule", name));
    device.name(VK_OBJECT_TYPE_SHADER_MODULE, handle, name);
    return ShaderModule(device.handle(), handle);
}

Specialization::Specialization(const PhysicalDevice& device,
                               std::span<const SpecializationConstant> constants)
    : constants_(constants.begin(), constants.end()) {
    constants_.push_back({0, device.kind == DeviceKind::cpu ? VK_TRUE : VK_FALSE});
    for (std::size_t i = 0; i < constants_.size(); ++i)
        entries_.push_back({constants_[i].id,
                            std::uint32_t(i * sizeof(SpecializationConstant) +
                                          offsetof(SpecializationConstant, value)),
                            sizeof(std::uint32_t)});
    info_ = {std::uint32_t(entries_.size()), entries_.data(),
             constants_.size() * sizeof(SpecializationConstant), constants_.data()};
}

Result<PipelineLayout> PipelineLayout::create(Device& device, std::string_view name,
                                              std::span<const SetLayout* const> sets,
                                              std::uint32_t push_constant_bytes) {
    HM_CHECK(push_constant_bytes <= device.limits().max_push_constant_bytes,
             "{}: {} bytes of push constants, the device supports {}", name, push_constant_bytes,
             device.limits().max_push_constant_bytes);
    PipelineLayout layout;
    std::vector<VkDescriptorSetLayout> handles;
    for (const SetLayout* set : sets) {
        if (set == nullptr && layout.empty_.handle() == VK_NULL_HANDLE) {
            HM_TRY_ASSIGN(layout.empty_, SetLayout::create(device, "empty set", {}));
        }
        handles.push_back(set != nullptr ? set->handle() : layout.empty_.handle());
    }
    const VkPushConstantRange range{VK_SHADER_STAGE_ALL, 0, push_constant_bytes};
    const VkPipelineLayoutCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
        .setLayoutCount = static_cast<std::uint32_t>(handles.size()),
        .pSetLayouts = handles.data(),
        .pushConstantRangeCount = push_constant_bytes > 0 ? 1u : 0u,
        .pPushConstantRanges = &range};
    VkPipelineLayout handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &handle),
                        "vkCreatePipelineLayout", name));
    device.name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, handle, name);
    layout.handle_ = {device.handle(), handle};
    return layout;
}

Result<ComputePipeline> ComputePipeline::create(Device& device, std::string_view name,
                                                const PipelineLayout& layout, Spirv spirv,
                                                PipelineCache* cache) {
    HM_TRY_ASSIGN(const ShaderModule module, make_shader_module(device, name, spirv));
    const Specialization specialization(device.physical(), {});
    const VkComputePipelineCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module.get(),
                  .pName = "main",
                  .pSpecializationInfo = specialization.info()},
        .layout = layout.handle()};
    VkPipeline handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateComputePipelines(
                            device.handle(), cache != nullptr ? cache->handle() : VK_NULL_HANDLE, 1,
                            &info, nullptr, &handle),
                        "vkCreateComputePipelines", name));
    device.name(VK_OBJECT_TYPE_PIPELINE, handle, name);
    ComputePipeline pipeline;
    pipeline.handle_ = {device.handle(), handle};
    return pipeline;
}

}  // namespace hm::rhi
