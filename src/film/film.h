// What renderers hand their samples to: sums per pixel, and the picture they make.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "shading/lang.h"

namespace hm {

// The sums of one pixel's samples, in the order of their indices.
struct PixelSum {
    vec3 radiance;  // premultiplied, linear Rec.709
    float alpha;
    float weight;   // how many samples
    float removed;  // luminance that --clamp took away
};

// Half-open, in pixels of the whole picture.
struct PixelRect {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::uint32_t width() const { return x1 - x0; }
    std::uint32_t height() const { return y1 - y0; }
};

struct Film {
    PixelRect crop;
    std::vector<PixelSum> sums;  // rows of crop.width()

    explicit Film(PixelRect rect);
    // rgba32f, premultiplied; a pixel without samples is black and transparent.
    Image resolve() const;
    // Mean luminance that clamping took from a pixel, and the mean that is left.
    double removed_luminance() const;
    double mean_luminance() const;
    double mean_samples() const;
};

}  // namespace hm
