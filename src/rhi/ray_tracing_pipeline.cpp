#include "rhi/ray_tracing_pipeline.h"

#include <fmt/format.h>

#include <cstring>

#include "base/check.h"
#include "rhi/commands.h"
#include "rhi/error.h"
#include "rhi/pipeline_cache.h"
#include "rhi/upload.h"

namespace hm::rhi {

namespace {

std::uint64_t align_up(std::uint64_t value, std::uint64_t alignment) {
    return (value + alignment - 1) / alignment * alignment;
}

// The stages and groups of a pipeline under construction.
struct Stages {
    Device& device;
    const std::string& name;
    const Specialization& specialization;
    std::vector<ShaderModule> modules;
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    std::vector<VkRayTracingShaderGroupCreateInfoKHR> groups;

    // Returns the stage's index; VK_SHADER_UNUSED_KHR if there is no code.
    Result<std::uint32_t> add_stage(VkShaderStageFlagBits stage, Spirv spirv) {
        if (spirv.empty()) return VK_SHADER_UNUSED_KHR;
        HM_TRY_ASSIGN(ShaderModule module, make_shader_module(device, name, spirv));
        stages.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                          .stage = stage,
                          .module = module.get(),
                          .pName = "main",
                          .pSpecializationInfo = specialization.info()});
        modules.push_back(std::move(module));
        return static_cast<std::uint32_t>(stages.size() - 1);
    }

    Result<void> add_general(VkShaderStageFlagBits stage, Spirv spirv) {
        HM_TRY_ASSIGN(const std::uint32_t index, add_stage(stage, spirv));
        groups.push_back({.sType = VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR,
                          .type = VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR,
                          .generalShader = index,
                          .closestHitShader = VK_SHADER_UNUSED_KHR,
                          .anyHitShader = VK_SHADER_UNUSED_KHR,
                          .intersectionShader = VK_SHADER_UNUSED_KHR});
        return {};
    }

    Result<void> add_hit(const HitGroup& group) {
        HM_TRY_ASSIGN(const std::uint32_t closest,
                      add_stage(VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, group.closest_hit));
        HM_TRY_ASSIGN(const std::uint32_t any,
                      add_stage(VK_SHADER_STAGE_ANY_HIT_BIT_KHR, group.any_hit));
        groups.push_back({.sType = VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR,
                          .type = VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR,
                          .generalShader = VK_SHADER_UNUSED_KHR,
                          .closestHitShader = closest,
                          .anyHitShader = any,
                          .intersectionShader = VK_SHADER_UNUSED_KHR});
        return {};
    }

    // Groups in the order of the shader binding table.
    Result<void> add_all(const RayTracingPipelineInfo& info) {
        HM_TRY(add_general(VK_SHADER_STAGE_RAYGEN_BIT_KHR, info.ray_generation));
        for (const Spirv miss : info.misses)
            HM_TRY(add_general(VK_SHADER_STAGE_MISS_BIT_KHR, miss));
        for (const HitGroup& group : info.hit_groups)
            HM_TRY(add_hit(group));
        return {};
    }
};

}  // namespace

Result<RayTracingPipeline> RayTracingPipeline::create(Device& device,
                                                      const RayTracingPipelineInfo& info,
                                                      PipelineCache* cache) {
    HM_CHECK(info.layout != nullptr && !info.ray_generation.empty(), "pipeline {}", info.name);
    if (info.max_recursion_depth > device.limits().max_recursion_depth)
        return fail(ErrorKind::no_device, "Vulkan", info.name,
                    fmt::format("rays that start {} deep; the device allows {}",
                                info.max_recursion_depth, device.limits().max_recursion_depth));
    const Specialization specialization(device.physical(), info.constants);
    Stages parts{device, info.name, specialization, {}, {}, {}};
    HM_TRY(parts.add_all(info));
    const VkRayTracingPipelineCreateInfoKHR create{
        .sType = VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR,
        .stageCount = static_cast<std::uint32_t>(parts.stages.size()),
        .pStages = parts.stages.data(),
        .groupCount = static_cast<std::uint32_t>(parts.groups.size()),
        .pGroups = parts.groups.data(),
        .maxPipelineRayRecursionDepth = info.max_recursion_depth,
        .layout = info.layout->handle()};
    VkPipeline handle = VK_NULL_HANDLE;
    const VkPipelineCache cache_handle = cache != nullptr ? cache->handle() : VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateRayTracingPipelinesKHR(device.handle(), VK_NULL_HANDLE,
                                                       cache_handle, 1, &create, nullptr, &handle),
                        "vkCreateRayTracingPipelinesKHR", info.name));
    device.name(VK_OBJECT_TYPE_PIPELINE, handle, info.name);
    RayTracingPipeline pipeline;
    pipeline.handle_ = {device.handle(), handle};
    HM_TRY(pipeline.make_table(device, info));
    return pipeline;
}

// Each of the table's three regions starts at an aligned address; within a region, handles are
// packed at their own, smaller alignment. No group has shader record data.
Result<void> RayTracingPipeline::make_table(Device& device, const RayTracingPipelineInfo& info) {
    const auto& limits = device.ray_tracing_limits();
    const std::uint64_t handle_size = limits.shaderGroupHandleSize;
    const std::uint64_t stride = align_up(handle_size, limits.shaderGroupHandleAlignment);
    const std::array<std::size_t, 3> counts{1, info.misses.size(), info.hit_groups.size()};
    std::array<std::uint64_t, 3> offsets{};
    std::uint64_t size = 0;
    for (std::size_t part = 0; part < 3; ++part) {
        offsets[part] = align_up(size, limits.shaderGroupBaseAlignment);
        size = offsets[part] + counts[part] * stride;
    }

    const std::size_t groups = counts[0] + counts[1] + counts[2];
    std::vector<std::byte> handles(groups * handle_size);
    HM_TRY(device.check(vkGetRayTracingShaderGroupHandlesKHR(device.handle(), handle_.get(), 0,
                                                             static_cast<std::uint32_t>(groups),
                                                             handles.size(), handles.data()),
                        "vkGetRayTracingShaderGroupHandlesKHR", info.name));
    std::vector<std::byte> table(size);
    const std::byte* next = handles.data();
    for (std::size_t part = 0; part < 3; ++part) {
        for (std::size_t i = 0; i < counts[part]; ++i, next += handle_size)
            std::memcpy(table.data() + offsets[part] + i * stride, next, handle_size);
    }

    HM_TRY_ASSIGN(table_, Buffer::create(device, {.name = info.name + ": shader binding table",
                                                  .size = size,
                                                  .use = BufferUse::shader_table,
                                                  .alignment = limits.shaderGroupBaseAlignment}));
    HM_TRY_ASSIGN(Uploader uploader, Uploader::create(device, size));
    HM_TRY(uploader.buffer(table_, table));
    HM_TRY(uploader.finish());
    for (std::size_t part = 0; part < 3; ++part)
        regions_[part] = {table_.address() + offsets[part], stride, counts[part] * stride};
    return {};
}

}  // namespace hm::rhi
