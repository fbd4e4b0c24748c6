// Pipeline layouts and compute pipelines. SPIR-V comes embedded (cmake/Shaders.cmake).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/result.h"
#include "rhi/descriptors.h"
#include "rhi/device.h"

namespace hm::rhi {

class PipelineCache;

// The words of one module whose entry point is `main`.
using Spirv = std::span<const std::uint32_t>;

using ShaderModule = Handle<VkShaderModule, &vkDestroyShaderModule>;
Result<ShaderModule> make_shader_module(Device& device, std::string_view name, Spirv spirv);

// What every shader is told of the device: constant_id 0, a bool, whether its quotients and roots
// are rounded as C++'s (shading/exact.glsl). Those of a CPU are.
const VkSpecializationInfo* shader_constants(const PhysicalDevice& device);

class PipelineLayout {
  public:
    PipelineLayout() = default;
    // Set i has layout sets[i]; a null one is an empty set. Push constants are seen by all stages.
    static Result<PipelineLayout> create(Device& device, std::string_view name,
                                         std::span<const SetLayout* const> sets,
                                         std::uint32_t push_constant_bytes = 0);
    VkPipelineLayout handle() const { return handle_.get(); }

  private:
    SetLayout empty_;
    Handle<VkPipelineLayout, &vkDestroyPipelineLayout> handle_;
};

class ComputePipeline {
  public:
    ComputePipeline() = default;
    static Result<ComputePipeline> create(Device& device, std::string_view name,
                                          const PipelineLayout& layout, Spirv spirv,
                                          PipelineCache* cache = nullptr);
    VkPipeline handle() const { return handle_.get(); }

  private:
    Handle<VkPipeline, &vkDestroyPipeline> handle_;
};

}  // namespace hm::rhi
