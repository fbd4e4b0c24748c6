// Converts linear radiance to display values: exposure, tone curve, sRGB, dither.
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

// The exposure that maps the log-average luminance (Reinhard et al. 2002) to 0.18. Pixels are
// weighted by alpha; those below a thousandth of the mean count as unlit and are excluded. 0 for a
// black picture.
float auto_exposure(const FloatImage& linear);

// Converts premultiplied radiance to sRGB with straight alpha. Ordered dithering with the
// blue-noise tile of the shading tables adds less than half a step, the same to all channels, so
// that greys stay grey and values that 8 bits can represent are exact. `crop` is the position of
// `linear` in the whole picture, to which the tile is aligned.
Image8 tone_map_picture(const FloatImage& linear, PixelRect crop, const ToneSettings& settings);

// Shares of a picture's pixels.
struct ToneShares {
    double black = 0;    // no channel above 1 of 255
    double clipped = 0;  // a channel of 254 or 255
};
ToneShares tone_shares(const Image8& picture);

}  // namespace hm
