// The formats one by one, from and to memory; read.cpp and write.cpp choose between them. Decoders
// may throw std::bad_alloc, nothing else. All are safe to call from several threads.
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

// By the first bytes.
FileFormat file_format(Bytes bytes);

// Fails if a header's claim is empty or larger than read.h allows. Decoders call it before they
// take memory.
Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::string_view name);

// Where the fast decoder refuses a file, libspng decides whether its pixels are whole.
Result<TextureImage> decode_png(Bytes bytes, std::string_view name, ReadWarnings& warnings);
// Ignores damaged ancillary chunks and surplus bytes. `sixteen_bits`: IHDR's depth is 16.
Result<TextureImage> decode_png_leniently(Bytes bytes, bool sixteen_bits);
Result<TextureImage> decode_jpeg(Bytes bytes, std::string_view name);
// As environments: read.h.
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
