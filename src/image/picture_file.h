// Reads image files of any format as layers.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "image/layers.h"
#include "image/read.h"

namespace hm {

struct PictureFile {
    LayeredImage picture;
    // PNG and JPEG: sRGB in [0, 1], composited over black. Otherwise linear.
    bool encoded = false;
    ReadWarnings warnings;
};

// OpenEXR with all layers; Radiance, PNG and JPEG as a single one. Fails like read_image and
// read_layers.
Result<PictureFile> read_picture_file(const std::filesystem::path& path);

}  // namespace hm
