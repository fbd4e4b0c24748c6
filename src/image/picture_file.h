// Any picture file as layers.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "image/layers.h"
#include "image/read.h"

namespace hm {

struct PictureFile {
    LayeredImage picture;
    // sRGB in [0, 1], as PNG and JPEG have it, with what is transparent over black; else linear.
    bool encoded = false;
    ReadWarnings warnings;
};

// OpenEXR with all its layers; Radiance, PNG and JPEG as one. Fails as read_image and read_layers.
Result<PictureFile> read_picture_file(const std::filesystem::path& path);

}  // namespace hm
