// The environment as rendering reads it: linear texels and their alias table.
#pragma once

#include <vector>

#include "image/image.h"
#include "shading/structs.h"

namespace hm {

struct EnvironmentMap {
    EnvironmentData data{};
    std::vector<vec4> texels;
    std::vector<AliasEntry> alias;
    float mean_radiance = 0;  // luminance averaged over the sphere, intensity included
};

// An equirectangular rgba32f picture, finite and not negative (image/read.h sees to that).
// rotation in degrees; intensity scales the radiance. A map of no light at all has intensity 0.
EnvironmentMap make_environment(const FloatImage& image, float rotation, float intensity);

// The neutral light a scene gets that has none of its own: a grey sky with a soft key light.
FloatImage default_environment();

}  // namespace hm
