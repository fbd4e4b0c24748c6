// Writes the finished picture to a file. The extension determines the format.
#pragma once

#include <filesystem>
#include <optional>

#include "base/result.h"
#include "image/layers.h"
#include "image/write.h"
#include "output/tonemap.h"

namespace hm {

enum class PictureKind { exr, png, hdr };

// By the extension, in upper or lower case; nullopt if it is not supported.
std::optional<PictureKind> picture_kind(const std::filesystem::path& path);

struct PictureOptions {
    PixelRect crop;      // position in the whole picture
    bool alpha = false;  // PNG only: write the alpha channel
    ToneSettings tone;   // PNG only
    ExrOptions exr{};
};

// .exr files contain all layers, .png and .hdr files the beauty only. `beauty` is premultiplied.
// The extension must be supported.
Result<void> write_picture(const std::filesystem::path& path, const FloatImage& beauty,
                           const LayeredImage& layers, const PictureOptions& options);

}  // namespace hm
