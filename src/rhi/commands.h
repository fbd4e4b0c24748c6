// Records commands for the queue.
//
//   HM_TRY_ASSIGN(Commands commands, Commands::begin(device, "trace"));
//   commands.bind(pipeline); ... commands.trace_rays(pipeline, width, height);
//   HM_TRY_ASSIGN(Ticket done, device.submit(commands));
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "rhi/barrier.h"
#include "rhi/buffer.h"
#include "rhi/descriptors.h"
#include "rhi/device.h"
#include "rhi/image.h"

namespace hm::rhi {

class ComputePipeline;
class PipelineLayout;
class RayTracingPipeline;

// A range of rows of one mip level of an image; the level is `width` texels wide.
struct ImageRows {
    std::uint32_t level = 0;
    std::uint32_t begin = 0;
    std::uint32_t count = 0;
    std::uint32_t width = 0;
};

// One command buffer with its own pool. begin() starts recording; Device::submit ends it. Once the
// submission's ticket is reached, begin_again() reuses the same memory. The destructor waits for
// the ticket.
class Commands {
  public:
    Commands() = default;
    Commands(Commands&& other) noexcept { swap(other); }
    Commands& operator=(Commands&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Commands();
    static Result<Commands> begin(Device& device, std::string_view name);
    Result<void> begin_again();

    void copy(const Buffer& from, const Buffer& to, std::uint64_t from_offset = 0,
              std::uint64_t to_offset = 0, std::uint64_t size = VK_WHOLE_SIZE);
    // Tightly packed rows of level 0; the image is in layout transfer_source or general.
    void copy(const Image& from, ImageLayout layout, const Buffer& to, std::uint64_t to_offset = 0);
    // Tightly packed rows of one mip level. With its first piece the whole level changes to layout
    // transfer_target, losing its contents; after its last piece it changes to shader_read.
    void copy(const Buffer& from, std::uint64_t from_offset, const Image& to, const ImageRows& rows,
              bool first, bool last);
    void fill(const Buffer& buffer, std::uint32_t value);  // repeats `value` every four bytes
    // The image is in layout transfer_target or general.
    void clear(const Image& image, ImageLayout layout, float value);

    void barriers(std::span<const Barrier> barriers);
    // A full execution and memory barrier. For single copies; passes get their barriers from the
    // render graph.
    void full_barrier();
    // The same for one image, with a layout transition; from undefined it loses its contents.
    void transition(const Image& image, ImageLayout from, ImageLayout to);

    void bind(const ComputePipeline& pipeline);
    void bind(const RayTracingPipeline& pipeline);
    // For the bind point of the pipeline that was bound last.
    void bind_set(const PipelineLayout& layout, std::uint32_t index, const DescriptorSet& set);
    void push_set(const PipelineLayout& layout, std::uint32_t index,
                  const DescriptorWrites& writes);
    void push_constants(const PipelineLayout& layout, std::span<const std::byte> bytes);
    template <class T>
    void push_constants(const PipelineLayout& layout, const T& value) {
        push_constants(layout, std::as_bytes(std::span(&value, 1)));
    }
    void dispatch(std::uint32_t groups_x, std::uint32_t groups_y = 1, std::uint32_t groups_z = 1);
    void trace_rays(const RayTracingPipeline& pipeline, std::uint32_t width, std::uint32_t height,
                    std::uint32_t depth = 1);

    // A named range for debuggers.
    void begin_label(std::string_view name);
    void end_label();

    const std::string& name() const { return name_; }
    VkCommandBuffer handle() const { return handle_; }

  private:
    friend class Device;
    void swap(Commands& other) noexcept;
    Result<void> start();
    Result<void> end();

    Device* device_ = nullptr;
    std::string name_;
    Handle<VkCommandPool, &vkDestroyCommandPool> pool_;
    VkCommandBuffer handle_ = VK_NULL_HANDLE;
    Ticket ticket_ = 0;  // of its last submission
    VkPipelineBindPoint bind_point_ = VK_PIPELINE_BIND_POINT_COMPUTE;
};

// Records, submits and waits.
Result<void> run_once(Device& device, std::string_view name,
                      const std::function<Result<void>(Commands&)>& record);

}  // namespace hm::rhi
