// Reads images from memory. The format is detected by the signature, never by the file name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace hm {

// Limits of width, height and number of pixels, checked before memory is allocated.
inline constexpr std::uint32_t kMaxImageSide = 65536;
inline constexpr std::uint64_t kMaxImagePixels = 1ull << 28;

// Faults of a file that could still be read, one line per kind.
using ReadWarnings = std::vector<std::string>;

// PNG (all colour types and depths; 16 bits are kept) or JPEG (grey, YCbCr, RGB, CMYK), with
// encoded values as stored. Alpha defaults to 1; grey is replicated; embedded colour profiles and
// gamma are ignored, as glTF requires. Faults that do not affect pixels (a bad checksum of an
// ancillary chunk, trailing bytes) are warnings. `name` is used in errors only. All three functions
// are thread-safe. They fail with ErrorKind::invalid, or with ErrorKind::unsupported if a valid
// file uses a feature that is not implemented.
Result<TextureImage> read_texture_image(std::span<const std::byte> bytes, std::string_view name,
                                        ReadWarnings& warnings);

// Radiance .hdr (RGBE or XYZE, flat or run-length encoded) or OpenEXR (scan lines or tiles; R, G, B
// or Y, else the first layer with R, G and B; the first part with colours), as linear Rec. 709 with
// alpha 1: other chromaticities are converted. The image covers OpenEXR's display window, and is
// black outside the data window. Infinite, NaN and negative values are replaced. Such changes are
// warnings.
Result<FloatImage> read_environment_image(std::span<const std::byte> bytes, std::string_view name,
                                          ReadWarnings& warnings);

// Any of these formats, for tools and tests; OpenEXR as in read_layers and layer_image.
Result<AnyImage> read_image(std::span<const std::byte> bytes, std::string_view name);

}  // namespace hm
