// Pictures from bytes. The file's signature decides on the format, never its name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace hm {

// The largest width or height and the most pixels of a picture; checked before memory is allocated.
inline constexpr std::uint32_t kMaxImageSide = 65536;
inline constexpr std::uint64_t kMaxImagePixels = 1ull << 28;

// What was wrong with a file that could be read all the same, a line for each kind of fault.
using ReadWarnings = std::vector<std::string>;

// PNG (every colour type and depth; 16-bit stays 16-bit) or JPEG (grey, YCbCr, RGB, CMYK), with the
// stored, still encoded values. A missing alpha is 1; grey is repeated; embedded
// colour profiles and gamma are ignored, as glTF asks. Faults that cost no pixel (a bad checksum of
// an ancillary chunk, bytes too many) are warnings. `name` is used in errors only.
// All three may be called from several threads at once. They fail with ErrorKind::invalid, or with
// ErrorKind::unsupported where a valid file uses a feature that is not implemented.
Result<TextureImage> read_texture_image(std::span<const std::byte> bytes, std::string_view name,
                                        ReadWarnings& warnings);

// Radiance .hdr (RGBE or XYZE, flat or run-length coded) or OpenEXR (scan lines or tiles; R, G, B
// or Y, else the first layer with R, G and B; of several parts the first with colours), as linear
// Rec. 709 with alpha 1: other chromaticities are converted. The picture is OpenEXR's display
// window, black where there is no data. Infinite, NaN and negative values become finite,
// non-negative ones. Each such change is a warning.
Result<FloatImage> read_environment_image(std::span<const std::byte> bytes, std::string_view name,
                                          ReadWarnings& warnings);

// Any of the above, for tools and tests: OpenEXR as read_layers and layer_image have it.
Result<AnyImage> read_image(std::span<const std::byte> bytes, std::string_view name);

}  // namespace hm
