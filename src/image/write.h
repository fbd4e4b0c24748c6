// Pictures to files, written under a temporary name and renamed.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "image/image.h"

namespace hm {

// Text attributes, in order: written as OpenEXR string attributes and PNG tEXt chunks.
using Metadata = std::vector<std::pair<std::string, std::string>>;

// Premultiplied linear Rec.709 (the chromaticities attribute says so), float channels R, G, B and,
// with `alpha`, A; ZIP-compressed scan lines.
Result<void> write_exr(const std::filesystem::path& path, const FloatImage& image, bool alpha,
                       const Metadata& metadata);

// sRGB with straight alpha; without `alpha` an RGB file. Carries an sRGB chunk.
Result<void> write_png(const std::filesystem::path& path, const Image8& image, bool alpha,
                       const Metadata& metadata);

// Radiance RGBE, run-length coded.
Result<void> write_hdr(const std::filesystem::path& path, const FloatImage& image);

}  // namespace hm
