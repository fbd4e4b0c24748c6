// Decoders and encoders of each format, in memory; read.cpp and write.cpp choose between them.
// Decoders may throw std::bad_alloc only. All functions are thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "image/layers.h"
#include "image/read.h"
#include "image/write.h"

namespace hm {

using Bytes = std::span<const std::byte>;

enum class FileFormat { unknown, png, jpeg, hdr, exr };

// Detected by the first bytes.
FileFormat file_format(Bytes bytes);

// Fails if the size is zero or exceeds the limits of read.h. Decoders call it before allocating.
Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::string_view name);

// If the fast decoder rejects a file, libspng decides whether its pixels are complete.
Result<TextureImage> decode_png(Bytes bytes, std::string_view name, ReadWarnings& warnings);
// Ignores damaged ancillary chunks and trailing data. `sixteen_bits`: the bit depth in IHDR is 16.
Result<TextureImage> decode_png_leniently(Bytes bytes, bool sixteen_bits);
Result<TextureImage> decode_jpeg(Bytes bytes, std::string_view name);
// For environments, see read.h.
Result<FloatImage> decode_hdr(Bytes bytes, std::string_view name, ReadWarnings& warnings);
Result<FloatImage> decode_exr(Bytes bytes, std::string_view name, ReadWarnings& warnings);
Result<LayeredImage> decode_layers(Bytes bytes, std::string_view name);

// Fail with ErrorKind::unwritable and an empty file name.
Result<std::vector<std::byte>> encode_png(const Image8& image, bool alpha,
                                          const Metadata& metadata);
Result<std::vector<std::byte>> encode_exr(const FloatImage& image, bool alpha,
                                          const Metadata& metadata);
Result<std::vector<std::byte>> encode_layers(const LayeredImage& picture,
                                             const ExrOptions& options);
std::vector<std::byte> encode_hdr(const FloatImage& image);

}  // namespace hm
