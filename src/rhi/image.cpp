#include "rhi/image.h"

#include <fmt/format.h>

#include <utility>

#include "base/check.h"
#include "rhi/memory.h"

namespace hm::rhi {

namespace {

VkImageUsageFlags usage_of(ImageUse use) {
    VkImageUsageFlags flags = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    if (has(use, ImageUse::sampled)) flags |= VK_IMAGE_USAGE_SAMPLED_BIT;
    if (has(use, ImageUse::storage)) flags |= VK_IMAGE_USAGE_STORAGE_BIT;
    return flags;
}

VkImageCreateInfo create_info(const ImageInfo& info) {
    HM_CHECK(info.width > 0 && info.height > 0 && info.levels > 0, "image {}: {} x {}, {} levels",
             info.name, info.width, info.height, info.levels);
    return {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
            .imageType = VK_IMAGE_TYPE_2D,
            .format = static_cast<VkFormat>(info.format),
            .extent = {info.width, info.height, 1},
            .mipLevels = info.levels,
            .arrayLayers = 1,
            .samples = VK_SAMPLE_COUNT_1_BIT,
            .tiling = VK_IMAGE_TILING_OPTIMAL,
            .usage = usage_of(info.use)};
}

// Queries the device, because creating an unsupported image is undefined behaviour.
Result<void> check_supported(const Device& device, const ImageInfo& info) {
    VkImageFormatProperties limits{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        device.physical().handle, static_cast<VkFormat>(info.format), VK_IMAGE_TYPE_2D,
        VK_IMAGE_TILING_OPTIMAL, usage_of(info.use), 0, &limits);
    HM_TRY(device.check(result, "vkGetPhysicalDeviceImageFormatProperties", info.name));
    if (info.width <= limits.maxExtent.width && info.height <= limits.maxExtent.height) return {};
    return fail(ErrorKind::device_failed, "Vulkan", info.name,
                fmt::format("an image of {} x {}; the device supports {} x {}", info.width,
                            info.height, limits.maxExtent.width, limits.maxExtent.height));
}

VkSamplerAddressMode address_mode(Wrap wrap) {
    switch (wrap) {
        case Wrap::mirrored_repeat:
            return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
        case Wrap::clamp_to_edge:
            return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
        case Wrap::repeat:
            break;
    }
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

}  // namespace

std::uint32_t bytes_per_texel(Format format) {
    switch (format) {
        case Format::r8:
            return 1;
        case Format::rg8:
            return 2;
        case Format::rgba8:
        case Format::rgba8_srgb:
        case Format::r32u:
        case Format::r32f:
            return 4;
        case Format::rgba16:
        case Format::rgba16f:
            return 8;
        case Format::rgba32f:
            break;
    }
    return 16;
}

MemoryNeeds memory_needs(const Device& device, const ImageInfo& info) {
    const VkImageCreateInfo create = create_info(info);
    const VkDeviceImageMemoryRequirements query{
        .sType = VK_STRUCTURE_TYPE_DEVICE_IMAGE_MEMORY_REQUIREMENTS, .pCreateInfo = &create};
    VkMemoryRequirements2 needs{.sType = VK_STRUCTURE_TYPE_MEMORY_REQUIREMENTS_2};
    vkGetDeviceImageMemoryRequirements(device.handle(), &query, &needs);
    return {needs.memoryRequirements.size, needs.memoryRequirements.alignment,
            needs.memoryRequirements.memoryTypeBits};
}

Result<Image> Image::create(Device& device, const ImageInfo& info) {
    HM_TRY(check_supported(device, info));
    Image image;
    image.device_ = &device;
    image.info_ = info;
    const VkImageCreateInfo create = create_info(info);
    const VmaAllocationCreateInfo allocate = allocation_info(MemoryKind::device);
    const VkResult result = vmaCreateImage(device.allocator(), &create, &allocate, &image.handle_,
                                           &image.allocation_, nullptr);
    if (result != VK_SUCCESS)
        return tl::unexpected(memory_error(device, result, "vmaCreateImage", info.name,
                                           memory_needs(device, info).bytes));
    HM_TRY(image.make_view(device));
    return image;
}

Result<Image> Image::create_in(Device& device, const ImageInfo& info, const MemoryBlock& block,
                               std::uint64_t offset) {
    HM_TRY(check_supported(device, info));
    Image image;
    image.device_ = &device;
    image.info_ = info;
    const VkImageCreateInfo create = create_info(info);
    HM_TRY(device.check(vmaCreateAliasingImage2(device.allocator(), block.allocation(), offset,
                                                &create, &image.handle_),
                        "vmaCreateAliasingImage2", info.name));
    HM_TRY(image.make_view(device));
    return image;
}

Result<void> Image::make_view(Device& device) {
    device.name(VK_OBJECT_TYPE_IMAGE, handle_, info_.name);
    const VkImageViewCreateInfo view{
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = handle_,
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = static_cast<VkFormat>(info_.format),
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, info_.levels, 0, 1}};
    HM_TRY(device.check(vkCreateImageView(device.handle(), &view, nullptr, &view_),
                        "vkCreateImageView", info_.name));
    device.name(VK_OBJECT_TYPE_IMAGE_VIEW, view_, info_.name);
    return {};
}

Image::~Image() {
    if (view_ != VK_NULL_HANDLE) vkDestroyImageView(device_->handle(), view_, nullptr);
    if (handle_ != VK_NULL_HANDLE) vmaDestroyImage(device_->allocator(), handle_, allocation_);
}

void Image::swap(Image& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(info_, other.info_);
    std::swap(handle_, other.handle_);
    std::swap(view_, other.view_);
    std::swap(allocation_, other.allocation_);
}

Result<Sampler> Sampler::create(Device& device, const SamplerInfo& info) {
    const VkFilter filter = info.filter == Filter::linear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    const VkSamplerCreateInfo create{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                     .magFilter = filter,
                                     .minFilter = filter,
                                     .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                     .addressModeU = address_mode(info.wrap_u),
                                     .addressModeV = address_mode(info.wrap_v),
                                     .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
                                     .maxLod = VK_LOD_CLAMP_NONE};
    VkSampler handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateSampler(device.handle(), &create, nullptr, &handle),
                        "vkCreateSampler", info.name));
    device.name(VK_OBJECT_TYPE_SAMPLER, handle, info.name);
    Sampler sampler;
    sampler.handle_ = {device.handle(), handle};
    return sampler;
}

}  // namespace hm::rhi
