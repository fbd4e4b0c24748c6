// Pipeline layouts and compute pipelines. SPIR-V comes embedded (cmake/Shaders.cmake).
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "rhi/descriptors.h"
#include "rhi/device.h"

namespace hm::rhi {

class PipelineCache;

// The words of one module whose entry point is `main`.
using Spirv = std::span<const std::uint32_t>;

using ShaderModule = Handle<VkShaderModule, &vkDestroyShaderModule>;
Result<ShaderModule> make_shader_module(Device& device, std::string_view name, Spirv spirv);

// The value of layout(constant_id = id), as its 32 bits. Modules without that constant ignore it.
struct SpecializationConstant {
    std::uint32_t id = 0;
    std::uint32_t value = 0;
    auto operator<=>(const SpecializationConstant&) const = default;
};

// The specialization constants of all stages of a pipeline: those given, and constant_id 0, a bool
// that says whether the device rounds quotients and roots as C++ does (shading/exact.glsl); CPUs
// do.
class Specialization {
  public:
    Specialization(const PhysicalDevice& device, std::span<const SpecializationConstant> constants);
    Specialization(const Specialization&) = delete;
    Specialization& operator=(const Specialization&) = delete;

    // Valid as long as this object.
    const VkSpecializationInfo* info() const { return &info_; }

  private:
    std::vector<SpecializationConstant> constants_;
    std::vector<VkSpecializationMapEntry> entries_;
    VkSpecializationInfo info_{};
};

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
