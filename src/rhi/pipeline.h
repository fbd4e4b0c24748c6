// Pipeline layouts and compute pipelines. SPIR-V is embedded in the program (cmake/Shaders.cmake).
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

// The 32-bit words of one SPIR-V module with entry point `main`.
using Spirv = std::span<const std::uint32_t>;

using ShaderModule = Handle<VkShaderModule, &vkDestroyShaderModule>;
Result<ShaderModule> make_shader_module(Device& device, std::string_view name, Spirv spirv);

// The 32-bit representation of the value of layout(constant_id = id). Modules without that constant
// ignore it.
struct SpecializationConstant {
    std::uint32_t id = 0;
    std::uint32_t value = 0;
    auto operator<=>(const SpecializationConstant&) const = default;
};

// The specialization constants of all stages of a pipeline: those passed in, and constant_id 0, a
// bool that is true if the device rounds division and square root as C++ does
// (shading/exact.glsl); CPU devices do.
class Specialization {
  public:
    Specialization(const PhysicalDevice& device, std::span<const SpecializationConstant> constants);
    Specialization(const Specialization&) = delete;
    Specialization& operator=(const Specialization&) = delete;

    // Valid for the lifetime of this object.
    const VkSpecializationInfo* info() const { return &info_; }

  private:
    std::vector<SpecializationConstant> constants_;
    std::vector<VkSpecializationMapEntry> entries_;
    VkSpecializationInfo info_{};
};

class PipelineLayout {
  public:
    PipelineLayout() = default;
    // Set i has layout sets[i]; null means an empty set. Push constants are visible to all stages.
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
