// Linear radiance to what a display shows: exposure, tone curve, sRGB, dither.
#pragma once

#include <cstdint>

#include "film/film.h"
#include "image/image.h"
#include "shading/color.h"

namespace hm {

struct ToneSettings {
    float exposure = 0;  // EV: radiance is multiplied by 2^exposure
    std::uint32_t curve = kToneNeutral;
};

// The exposure that brings the log-average of the luminance (Reinhard et al. 2002) to 0.18. Pixels
// count by their alpha; those below a thousandth of the mean are taken for unlit and left out. 0
// for a black picture.
float auto_exposure(const FloatImage& linear);

// Premultiplied radiance to sRGB with straight alpha. Ordered dither with the blue-noise tile of
// the shading tables, at most half a step either way and the same for all channels, so that greys
// stay grey and values that 8 bits hold exactly stay as they are. The tile follows the whole
// picture's pixels: `crop` is where `linear` lies in it.
Image8 tone_map_picture(const FloatImage& linear, PixelRect crop, const ToneSettings& settings);

}  // namespace hm
