// The environment map as the renderer reads it: linear texels and their alias table.
#pragma once

#include <vector>

#include "image/image.h"
#include "shading/structs.h"

namespace hm {

struct EnvironmentMap {
    EnvironmentData data{};
    std::vector<vec4> texels;
    std::vector<AliasEntry> alias;
    float mean_radiance = 0;  // mean luminance over the sphere, including intensity
};

// `image` is an equirectangular rgba32f image, finite and non-negative (image/read.h ensures it).
// rotation is in degrees; intensity scales the radiance. An all-black map gets intensity 0.
EnvironmentMap make_environment(const FloatImage& image, float rotation, float intensity);

// The neutral default lighting for scenes without lights: a grey sky and a soft key light from the
// upper left of the default view, so that the three visible faces of a box differ. No matte surface
// reflects more than 1 (docs/decisions/0016).
FloatImage default_environment();

}  // namespace hm
