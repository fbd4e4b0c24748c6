// What a public Picture holds.
#pragma once

#include <himalaya/picture.h>

#include "session/pictures.h"

namespace himalaya {

struct Picture::Impl {
    hm::FinishedPicture finished;
    std::uint32_t width = 0, height = 0;
    std::vector<float> pixels;  // RGBA
    bool complete = false;
    double samples_per_pixel = 0;
    std::string device;
    std::vector<std::string> warnings;
};

}  // namespace himalaya
