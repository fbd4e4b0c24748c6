// A two-dimensional image with its memory and its view, and samplers.
#pragma once

#include <cstdint>
#include <string>

#include "base/result.h"
#include "rhi/device.h"
#include "rhi/flags.h"
#include "rhi/memory_block.h"

struct VmaAllocation_T;

namespace hm::rhi {

// Values are Vulkan's.
enum class Format : std::uint32_t {
    r8 = VK_FORMAT_R8_UNORM,
    rg8 = VK_FORMAT_R8G8_UNORM,
    rgba8 = VK_FORMAT_R8G8B8A8_UNORM,
    rgba8_srgb = VK_FORMAT_R8G8B8A8_SRGB,
    rgba16 = VK_FORMAT_R16G16B16A16_UNORM,
    rgba16f = VK_FORMAT_R16G16B16A16_SFLOAT,
    r32u = VK_FORMAT_R32_UINT,
    r32f = VK_FORMAT_R32_SFLOAT,
    rgba32f = VK_FORMAT_R32G32B32A32_SFLOAT,
};
std::uint32_t bytes_per_texel(Format format);

// In addition, every image can be cleared and copied from and to.
enum class ImageUse : std::uint32_t { none = 0, sampled = 1, storage = 2 };
template <>
inline constexpr bool kIsFlags<ImageUse> = true;

// Values are Vulkan's.
enum class ImageLayout : std::uint32_t {
    undefined = VK_IMAGE_LAYOUT_UNDEFINED,
    general = VK_IMAGE_LAYOUT_GENERAL,
    shader_read = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
    transfer_source = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
    transfer_target = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
};

struct ImageInfo {
    std::string name;
    Format format = Format::rgba8;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t levels = 1;  // mip levels
    ImageUse use = ImageUse::sampled;
};

class Image {
  public:
    Image() = default;
    static Result<Image> create(Device& device, const ImageInfo& info);
    // Creates the image in a memory block, which other images may share and which must outlive it.
    static Result<Image> create_in(Device& device, const ImageInfo& info, const MemoryBlock& block,
                                   std::uint64_t offset);
    Image(Image&& other) noexcept { swap(other); }
    Image& operator=(Image&& other) noexcept {
        swap(other);
        return *this;
    }
    ~Image();

    explicit operator bool() const { return handle_ != VK_NULL_HANDLE; }
    const ImageInfo& info() const { return info_; }
    VkImage handle() const { return handle_; }
    VkImageView view() const { return view_; }  // of all mip levels

  private:
    Result<void> make_view(Device& device);
    void swap(Image& other) noexcept;

    Device* device_ = nullptr;
    ImageInfo info_;
    VkImage handle_ = VK_NULL_HANDLE;
    VkImageView view_ = VK_NULL_HANDLE;
    VmaAllocation_T* allocation_ = nullptr;
};

enum class Filter { nearest, linear };
enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

struct SamplerInfo {
    std::string name;
    Filter filter = Filter::nearest;
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
};

class Sampler {
  public:
    Sampler() = default;
    static Result<Sampler> create(Device& device, const SamplerInfo& info);
    VkSampler handle() const { return handle_.get(); }

  private:
    Handle<VkSampler, &vkDestroySampler> handle_;
};

}  // namespace hm::rhi
