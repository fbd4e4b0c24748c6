// The finished picture to a file; the extension says which kind.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"
#include "image/layers.h"
#include "image/write.h"
#include "output/tonemap.h"

namespace hm {

enum class PictureKind { exr, png, hdr };

// By the extension, in upper or lower case; nothing if it is none of ours.
std::optional<PictureKind> picture_kind(const std::filesystem::path& path);

struct PictureOptions {
    PixelRect crop;      // where the picture lies in the whole
    bool alpha = false;  // PNG only: write the coverage
    ToneSettings tone;   // PNG only
    ExrOptions exr{};
};

// .exr gets all layers and .png and .hdr the beauty alone, which is premultiplied. The
// extension must be known.
Result<void> write_picture(const std::filesystem::path& path, const FloatImage& beauty,
                           const LayeredImage& layers, const PictureOptions& options);

}  // namespace hm
