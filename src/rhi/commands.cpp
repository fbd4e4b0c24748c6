#include "rhi/commands.h"

#include <utility>
#include <vector>

#include "base/check.h"
#include "rhi/error.h"
#include "rhi/pipeline.h"
#include "rhi/ray_tracing_pipeline.h"

namespace hm::rhi {

Result<Commands> Commands::begin(Device& device, std::string_view name) {
    Commands commands;
    commands.device_ = &device;
    commands.name_ = name;
    const VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                            .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                            .queueFamilyIndex = device.physical().queue_family};
    VkCommandPool pool = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateCommandPool(device.handle(), &pool_info, nullptr, &pool),
                        "vkCreateCommandPool", name));
    commands.pool_ = {device.handle(), pool};
    const VkCommandBufferAllocateInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                           .commandPool = pool,
                                           .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                           .commandBufferCount = 1};
    HM_TRY(device.check(vkAllocateCommandBuffers(device.handle(), &info, &commands.handle_),
                        "vkAllocateCommandBuffers", name));
    device.name(VK_OBJECT_TYPE_COMMAND_BUFFER, commands.handle_, name);
    HM_TRY(commands.start());
    return commands;
}

Commands::~Commands() {
    // If this fails, an earlier call has already reported the device's failure.
    if (pool_.get() != VK_NULL_HANDLE && ticket_ > 0) static_cast<void>(device_->wait(ticket_));
}

void Commands::swap(Commands& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(name_, other.name_);
    std::swap(pool_, other.pool_);
    std::swap(handle_, other.handle_);
    std::swap(ticket_, other.ticket_);
    std::swap(bind_point_, other.bind_point_);
}

Result<void> Commands::begin_again() {
    HM_TRY(device_->check(vkResetCommandPool(device_->handle(), pool_.get(), 0),
                          "vkResetCommandPool", name_));
    return start();
}

Result<void> Commands::start() {
    const VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                        .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    return device_->check(vkBeginCommandBuffer(handle_, &info), "vkBeginCommandBuffer", name_);
}

Result<void> Commands::end() {
    // A semaphore does not make writes visible to the host.
    const Barrier to_host{.before = kEverything,
                          .after = {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT}};
    barriers(std::span(&to_host, 1));
    return device_->check(vkEndCommandBuffer(handle_), "vkEndCommandBuffer", name_);
}

void Commands::copy(const Buffer& from, const Buffer& to, std::uint64_t from_offset,
                    std::uint64_t to_offset, std::uint64_t size) {
    if (size == VK_WHOLE_SIZE) size = from.size() - from_offset;
    HM_CHECK(from_offset + size <= from.size() && to_offset + size <= to.size(),
             "{} bytes from {} of {} to {} of {}", size, from_offset, from.size(), to_offset,
             to.size());
    const VkBufferCopy region{from_offset, to_offset, size};
    vkCmdCopyBuffer(handle_, from.handle(), to.handle(), 1, &region);
}

void Commands::copy(const Image& from, ImageLayout layout, const Buffer& to,
                    std::uint64_t to_offset) {
    const ImageInfo& info = from.info();
    const std::uint64_t bytes =
        std::uint64_t{info.width} * info.height * bytes_per_texel(info.format);
    HM_CHECK(to_offset + bytes <= to.size(), "image {}: {} bytes at {} of {}", info.name, bytes,
             to_offset, to.size());
    const VkBufferImageCopy region{.bufferOffset = to_offset,
                                   .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                   .imageExtent = {info.width, info.height, 1}};
    vkCmdCopyImageToBuffer(handle_, from.handle(), static_cast<VkImageLayout>(layout), to.handle(),
                           1, &region);
}

namespace {

// A barrier for one mip level between a copy and all other work.
void level_barrier(VkCommandBuffer commands, const Image& image, std::uint32_t level,
                   VkImageLayout from, VkImageLayout to) {
    const VkImageMemoryBarrier2 barrier{
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = kEverything.stages,
        .srcAccessMask = kEverything.access,
        .dstStageMask = kEverything.stages,
        .dstAccessMask = kEverything.access,
        .oldLayout = from,
        .newLayout = to,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image.handle(),
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, level, 1, 0, 1}};
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                .imageMemoryBarrierCount = 1,
                                .pImageMemoryBarriers = &barrier};
    vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace

void Commands::copy(const Buffer& from, std::uint64_t from_offset, const Image& to,
                    const ImageRows& rows, bool first, bool last) {
    if (first)
        level_barrier(handle_, to, rows.level, VK_IMAGE_LAYOUT_UNDEFINED,
                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkBufferImageCopy region{
        .bufferOffset = from_offset,
        .imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, rows.level, 0, 1},
        .imageOffset = {0, static_cast<std::int32_t>(rows.begin), 0},
        .imageExtent = {rows.width, rows.count, 1}};
    vkCmdCopyBufferToImage(handle_, from.handle(), to.handle(),
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    if (last)
        level_barrier(handle_, to, rows.level, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                      VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

void Commands::fill(const Buffer& buffer, std::uint32_t value) {
    vkCmdFillBuffer(handle_, buffer.handle(), 0, VK_WHOLE_SIZE, value);
}

void Commands::clear(const Image& image, ImageLayout layout, float value) {
    const VkClearColorValue colour{.float32 = {value, value, value, value}};
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
    vkCmdClearColorImage(handle_, image.handle(), static_cast<VkImageLayout>(layout), &colour, 1,
                         &all);
}

void Commands::barriers(std::span<const Barrier> barriers) {
    std::vector<VkMemoryBarrier2> memory;
    std::vector<VkImageMemoryBarrier2> images;
    for (const Barrier& barrier : barriers) {
        if (barrier.image == nullptr) {
            memory.push_back({.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
                              .srcStageMask = barrier.before.stages,
                              .srcAccessMask = barrier.before.access,
                              .dstStageMask = barrier.after.stages,
                              .dstAccessMask = barrier.after.access});
            continue;
        }
        images.push_back(
            {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
             .srcStageMask = barrier.before.stages,
             .srcAccessMask = barrier.before.access,
             .dstStageMask = barrier.after.stages,
             .dstAccessMask = barrier.after.access,
             .oldLayout = static_cast<VkImageLayout>(barrier.from),
             .newLayout = static_cast<VkImageLayout>(barrier.to),
             .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
             .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
             .image = barrier.image->handle(),
             .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, 1}});
    }
    const VkDependencyInfo info{
        .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
        .memoryBarrierCount = static_cast<std::uint32_t>(memory.size()),
        .pMemoryBarriers = memory.data(),
        .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
        .pImageMemoryBarriers = images.data()};
    if (!barriers.empty()) vkCmdPipelineBarrier2(handle_, &info);
}

void Commands::full_barrier() {
    const Barrier all{.before = kEverything, .after = kEverything};
    barriers(std::span(&all, 1));
}

void Commands::transition(const Image& image, ImageLayout from, ImageLayout to) {
    const Barrier change{
        .before = kEverything, .after = kEverything, .image = &image, .from = from, .to = to};
    barriers(std::span(&change, 1));
}

void Commands::bind(const ComputePipeline& pipeline) {
    bind_point_ = VK_PIPELINE_BIND_POINT_COMPUTE;
    vkCmdBindPipeline(handle_, bind_point_, pipeline.handle());
}

void Commands::bind(const RayTracingPipeline& pipeline) {
    bind_point_ = VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR;
    vkCmdBindPipeline(handle_, bind_point_, pipeline.handle());
}

void Commands::bind_set(const PipelineLayout& layout, std::uint32_t index,
                        const DescriptorSet& set) {
    const VkDescriptorSet handle = set.handle();
    vkCmdBindDescriptorSets(handle_, bind_point_, layout.handle(), index, 1, &handle, 0, nullptr);
}

void Commands::push_set(const PipelineLayout& layout, std::uint32_t index,
                        const DescriptorWrites& writes) {
    const std::vector<VkWriteDescriptorSet> list = writes.for_set(VK_NULL_HANDLE);
    vkCmdPushDescriptorSetKHR(handle_, bind_point_, layout.handle(), index,
                              static_cast<std::uint32_t>(list.size()), list.data());
}

void Commands::push_constants(const PipelineLayout& layout, std::span<const std::byte> bytes) {
    vkCmdPushConstants(handle_, layout.handle(), VK_SHADER_STAGE_ALL, 0,
                       static_cast<std::uint32_t>(bytes.size()), bytes.data());
}

void Commands::dispatch(std::uint32_t groups_x, std::uint32_t groups_y, std::uint32_t groups_z) {
    vkCmdDispatch(handle_, groups_x, groups_y, groups_z);
}

void Commands::trace_rays(const RayTracingPipeline& pipeline, std::uint32_t width,
                          std::uint32_t height, std::uint32_t depth) {
    const auto& regions = pipeline.regions();
    vkCmdTraceRaysKHR(handle_, &regions[0], &regions[1], &regions[2], &regions[3], width, height,
                      depth);
}

void Commands::begin_label(std::string_view name) {
    if (!device_->instance().names_objects()) return;
    const std::string text(name);
    const VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT,
                                     .pLabelName = text.c_str()};
    vkCmdBeginDebugUtilsLabelEXT(handle_, &label);
}

void Commands::end_label() {
    if (device_->instance().names_objects()) vkCmdEndDebugUtilsLabelEXT(handle_);
}

Result<void> run_once(Device& device, std::string_view name,
                      const std::function<Result<void>(Commands&)>& record) {
    HM_TRY_ASSIGN(Commands commands, Commands::begin(device, name));
    HM_TRY(record(commands));
    HM_TRY_ASSIGN(const Ticket done, device.submit(commands));
    return device.wait(done);
}

}  // namespace hm::rhi
