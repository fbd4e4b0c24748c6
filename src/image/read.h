// Pictures from bytes. The format is told by the file's signature, never by its name.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace hm {

// No picture may be larger than this in either direction or in all; checked before memory is taken.
inline constexpr std::uint32_t kMaxImageSide = 65536;
inline constexpr std::uint64_t kMaxImagePixels = 1ull << 28;

// PNG (every colour type and depth; 16-bit stays 16-bit) or JPEG (grey, YCbCr, RGB, CMYK), as rgba8
// or rgba16 with the stored, still encoded values. A missing alpha is 1; grey is repeated; embedded
// colour profiles and gamma are ignored, as glTF asks. `name` is used in messages only.
// All three may be called from several threads at once. They fail with ErrorKind::invalid, or with
// ErrorKind::unsupported where the file is right but says something this program does not read.
Result<Image> read_texture_image(std::span<const std::byte> bytes, std::string_view name);

// Radiance .hdr (RGBE, flat or run-length coded) or OpenEXR (R, G, B or Y; scan lines or tiles), as
// linear rgba32f with alpha 1. Infinite, NaN and negative values become finite, non-negative ones.
Result<Image> read_environment_image(std::span<const std::byte> bytes, std::string_view name);

// Any of the above, for tools and tests: values of an OpenEXR file are as stored, with its alpha.
Result<Image> read_image(std::span<const std::byte> bytes, std::string_view name);

}  // namespace hm
