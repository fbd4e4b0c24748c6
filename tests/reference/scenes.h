// Small scenes that are defined identically for this renderer and Mitsuba 3; make_references.py is
// the Python version. Pictures are 48 by 32 pixels, box filter, energy compensation off.
#pragma once

#include <string_view>

#include "scene/environment.h"
#include "scene/scene.h"

namespace hm::test {

inline constexpr std::uint32_t kReferenceWidth = 48;
inline constexpr std::uint32_t kReferenceHeight = 32;

struct ReferenceCase {
    Scene scene;
    EnvironmentMap environment;
    CameraData camera{};
    std::uint32_t max_bounces = 0;
};

// A closed room, Lambertian only, lit by a quad: eight bounces.
ReferenceCase reference_box();
// Metal of base colour 1, roughness 0.3, 0.5 and 0.8, under a sky: no limit of bounces.
ReferenceCase reference_metal();
// Metallic 0, 0.5 and 1 by roughness 0.3, 0.6 and 1, under a turned sky and a lamp.
ReferenceCase reference_materials();
// A point, a directional and a spot light with range.
ReferenceCase reference_punctual();
// Textured cards in front of and behind the focal plane of a thin lens.
ReferenceCase reference_lens();
// Cards of alpha 0.35, of a pattern of alphas, and cut out, before a ball.
ReferenceCase reference_transparency();

}  // namespace hm::test
