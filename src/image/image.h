// Images in memory: four channels, rows from top to bottom, no padding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace hm {

// Red, green, blue, alpha.
template <class T>
using Rgba = std::array<T, 4>;

template <class T>
struct ImageOf {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Rgba<T>> pixels;  // width * height

    ImageOf() = default;
    // All channels zero.
    ImageOf(std::uint32_t w, std::uint32_t h) : width(w), height(h), pixels(std::size_t(w) * h) {}
};

using FloatImage = ImageOf<float>;       // linear
using Image8 = ImageOf<std::uint8_t>;    // 0..255 represents 0..1
using Image16 = ImageOf<std::uint16_t>;  // 0..65535 represents 0..1

// Storage format of texture pixels.
enum class PixelFormat : std::uint32_t { rgba8 = 0, rgba16 = 1 };

constexpr std::size_t bytes_per_pixel(PixelFormat format) {
    return format == PixelFormat::rgba8 ? sizeof(Rgba<std::uint8_t>) : sizeof(Rgba<std::uint16_t>);
}

// An image as stored in PNG and JPEG: encoded values, usually sRGB.
class TextureImage {
  public:
    TextureImage() = default;
    TextureImage(Image8 image) : image_(std::move(image)) {}
    TextureImage(Image16 image) : image_(std::move(image)) {}

    PixelFormat format() const { return PixelFormat(image_.index()); }
    std::uint32_t width() const {
        return std::visit([](const auto& image) { return image.width; }, image_);
    }
    std::uint32_t height() const {
        return std::visit([](const auto& image) { return image.height; }, image_);
    }
    std::span<const std::byte> bytes() const {
        return std::visit([](const auto& image) { return std::as_bytes(std::span(image.pixels)); },
                          image_);
    }
    // Image8 or Image16.
    const std::variant<Image8, Image16>& image() const { return image_; }

  private:
    std::variant<Image8, Image16> image_;  // in the order of PixelFormat
};

// The content of any image file.
using AnyImage = std::variant<TextureImage, FloatImage>;

}  // namespace hm
