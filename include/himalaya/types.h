// Small vectors and a matrix, for passing values only.
#pragma once

#include <array>
#include <cstdint>

namespace himalaya {

struct Vec2 {
    float x = 0, y = 0;
};

struct Vec3 {
    float x = 0, y = 0, z = 0;
};

// For positions: scenes may be millions of metres from the origin.
struct Vec3d {
    double x = 0, y = 0, z = 0;
};

struct Vec4 {
    float x = 0, y = 0, z = 0, w = 0;
};

// Indices of a triangle's vertices, counter-clockwise seen from its front.
using Triangle = std::array<std::uint32_t, 3>;

// Columns one after the other, as in glTF; the identity by default.
using Matrix = std::array<double, 16>;
inline constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

constexpr Matrix translation(Vec3d v) {
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, v.x, v.y, v.z, 1};
}

}  // namespace himalaya
