// The numbers of lights and cameras that animations can set, each listed once: here follow
// AnimatedValue (scene/animation.h), reading, writing and clamping (scene/animated_values.cpp), and
// the targets of KHR_animation_pointer (gltf/animation_pointer.cpp). Those of materials are in
// shading/material/parameters.inl. Define HM_ANIMATED, then include this file, which undefines it.
//
// HM_ANIMATED(value, pointer, table, member, low, high)
//   value      the name in AnimatedValue
//   pointer    in a glTF file; # is the owner's index
//   table      the member of Scene that holds the owners
//   member     of the owner: a float or a vec3
//   low, high  the range that interpolated values are clamped to: kLeast is a small positive number,
//              kMost the largest float

HM_ANIMATED(light_color, "/extensions/KHR_lights_punctual/lights/#/color", lights, color, 0, kMost)
HM_ANIMATED(light_intensity, "/extensions/KHR_lights_punctual/lights/#/intensity", lights, intensity,
            0, kMost)
HM_ANIMATED(light_range, "/extensions/KHR_lights_punctual/lights/#/range", lights, range, kLeast, kMost)
HM_ANIMATED(inner_cone, "/extensions/KHR_lights_punctual/lights/#/spot/innerConeAngle", lights,
            inner_cone, 0, kPi / 2)
HM_ANIMATED(outer_cone, "/extensions/KHR_lights_punctual/lights/#/spot/outerConeAngle", lights,
            outer_cone, kLeast, kPi / 2)
HM_ANIMATED(yfov, "/cameras/#/perspective/yfov", cameras, yfov, kLeast, kPi - kLeast)
HM_ANIMATED(xmag, "/cameras/#/orthographic/xmag", cameras, xmag, kLeast, kMost)
HM_ANIMATED(ymag, "/cameras/#/orthographic/ymag", cameras, ymag, kLeast, kMost)

#undef HM_ANIMATED
