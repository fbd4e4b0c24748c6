// Writes images to files, atomically: under a temporary name, then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace hm {

// Text attributes in order, written as OpenEXR string attributes and PNG tEXt chunks.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// Premultiplied linear Rec. 709 (with the chromaticities attribute); float channels R, G, B and, if
// `alpha`, A; ZIP-compressed scan lines.
Result<void> write_exr(const std::filesystem::path& path, const FloatImage& image, bool alpha,
                       const Metadata& metadata);

// sRGB with straight alpha, or RGB without `alpha`. Has an sRGB chunk.
Result<void> write_png(const std::filesystem::path& path, const Image8& image, bool alpha,
                       const Metadata& metadata);

// Radiance RGBE, run-length encoded.
Result<void> write_hdr(const std::filesystem::path& path, const FloatImage& image);

}  // namespace hm
