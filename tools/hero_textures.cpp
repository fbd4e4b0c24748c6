#include "hero_textures.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "noise.h"

namespace hm {
namespace {

std::uint8_t byte_of(float x) {
    return std::uint8_t(std::clamp(x, 0.0f, 1.0f) * 255 + 0.5f);
}

float srgb_of(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

// Samples the linear color(u, v) and encodes it as sRGB. Alpha is kept if there are 4 channels.
Picture paint(std::uint32_t width, std::uint32_t height, std::uint32_t channels,
              const std::function<glm::vec4(float u, float v)>& color) {
    Picture picture{width, height, channels, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const glm::vec4 c =
                color((float(x) + 0.5f) / float(width), (float(y) + 0.5f) / float(height));
            for (int i = 0; i < 3; ++i)
                picture.pixels.push_back(byte_of(srgb_of(c[i])));
            if (channels == 4) picture.pixels.push_back(byte_of(c.w));
        }
    return picture;
}

// Tangent-space normals of height(u, v), in units of the texture's width.
Picture paint_normals(std::uint32_t side, const std::function<float(float u, float v)>& height) {
    Picture picture{side, side, 3, {}};
    const float step = 1 / float(side);
    std::vector<float> h;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            h.push_back(height((float(x) + 0.5f) * step, (float(y) + 0.5f) * step));
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return h[y % side * side + x % side]; };
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const float du = (at(x + 1, y) - at(x + side - 1, y)) / (2 * step);
            const float dv = (at(x, y + 1) - at(x, y + side - 1)) / (2 * step);
            const glm::vec3 n = glm::normalize(glm::vec3(-du, dv, 1));  // y points up the picture
            for (int i = 0; i < 3; ++i)
                picture.pixels.push_back(byte_of(0.5f + 0.5f * n[i]));
        }
    return picture;
}

// --- Paving: six courses of slabs in broken bond ------------------------------------------------

struct Slab {
    float edge;  // distance to the slab's edge, in courses
    std::uint32_t id;
};

Slab slab_at(float u, float v) {
    constexpr int kCourses = 6;
    const glm::vec2 warp(fbm({u * 12, v * 12}, 3, 12, 70), fbm({u * 12, v * 12}, 3, 12, 80));
    const float y = v * kCourses + 0.035f * warp.y;
    const int course = (int(std::floor(y)) + kCourses) % kCourses;
    const float fy = y - std::floor(y);
    // Joints of a course: four slabs of unequal length.
    const float shift = hash_unit(std::uint32_t(course), 0, 11);
    float x = u + 0.035f / kCourses * warp.x + shift;
    x = (x - std::floor(x)) * 4;
    const auto joint = [&](int i) {
        return float(i) +
               0.5f * (hash_unit(std::uint32_t((i + 4) % 4), std::uint32_t(course), 12) - 0.5f);
    };
    int slab = int(std::floor(x));
    if (x < joint(slab)) --slab;
    if (x >= joint(slab + 1)) ++slab;
    const float left = (x - joint(slab)) * kCourses / 4.0f;
    const float right = (joint(slab + 1) - x) * kCourses / 4.0f;
    const float edge = std::min(std::min(fy, 1 - fy), std::min(left, right));
    return {edge, hash(std::uint32_t((slab + 4) % 4), std::uint32_t(course), 13)};
}

float slab_unit(const Slab& slab, std::uint32_t seed) {
    return hash_unit(slab.id, 0, seed);
}

float slab_height(float u, float v) {
    const Slab slab = slab_at(u, v);
    const glm::vec2 p(u, v);
    const float tilt = 0.006f * (slab_unit(slab, 1) - 0.5f) * std::sin(6.2831853f * u) +
                       0.003f * slab_unit(slab, 2);
    const float rim = 0.010f * smooth_step(0.012f, 0.085f, slab.edge);
    const float rough = 0.0022f * fbm(p * 16.0f, 5, 16, 20);
    const float chips = 0.004f * smooth_step(0.35f, 0.1f, cellular(p * 22.0f, 22, 25).nearest) *
                        smooth_step(0.1f, 0.5f, fbm(p * 8.0f, 3, 8, 26));
    return rim + tilt + rough - chips;
}

glm::vec4 slab_color(float u, float v) {
    const Slab slab = slab_at(u, v);
    const glm::vec2 p(u, v);
    const glm::vec3 cool(0.25f, 0.245f, 0.25f), warm(0.36f, 0.30f, 0.235f);
    glm::vec3 color = glm::mix(cool, warm, slab_unit(slab, 3));
    color *= 0.75f + 0.5f * slab_unit(slab, 4);
    color *= 1 + 0.35f * fbm(p * 10.0f, 6, 10, 30);
    const float lichen = smooth_step(0.22f, 0.34f, fbm(p * 6.0f, 5, 6, 40));
    color = glm::mix(color, glm::vec3(0.40f, 0.38f, 0.24f), 0.5f * lichen);
    const float joint = smooth_step(0.055f, 0.015f, slab.edge);
    const float moss = smooth_step(-0.1f, 0.25f, fbm(p * 5.0f, 3, 5, 50));
    const glm::vec3 filling =
        glm::mix(glm::vec3(0.075f, 0.06f, 0.045f), glm::vec3(0.08f, 0.10f, 0.03f), moss);
    return glm::vec4(glm::mix(color, filling, joint), 1);
}

// Damp where rain collects. glTF: roughness in green, metalness in blue, linear.
Picture paint_slab_roughness(std::uint32_t side) {
    Picture picture{side, side, 3, {}};
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const glm::vec2 p((float(x) + 0.5f) / float(side), (float(y) + 0.5f) / float(side));
            const float damp = smooth_step(0.0f, 0.22f, fbm(p * 3.0f, 4, 3, 60));
            const float joint = smooth_step(0.055f, 0.015f, slab_at(p.x, p.y).edge);
            const float dry = 0.72f + 0.25f * fbm(p * 20.0f, 4, 20, 61);
            const float roughness = glm::mix(glm::mix(dry, 0.22f, damp), 0.95f, joint);
            for (const float value : {1.0f, roughness, 0.0f})
                picture.pixels.push_back(byte_of(value));
        }
    return picture;
}

// --- Stone, plaster, metal ----------------------------------------------------------------------

float rock_height(float u, float v) {
    const glm::vec2 p(u, v);
    const glm::vec2 q =
        p * 4.0f + 0.6f * glm::vec2(fbm(p * 4.0f, 3, 4, 90), fbm(p * 4.0f, 3, 4, 91));
    const float facets = std::min(cellular(q, 4, 92).second - cellular(q, 4, 92).nearest, 0.5f);
    return 0.022f * facets + 0.016f * fbm(p * 6.0f, 7, 6, 95);
}

glm::vec4 rock_color(float u, float v) {
    const glm::vec2 p(u, v);
    const float tone = fbm(p * 3.0f, 6, 3, 100), grain = fbm(p * 24.0f, 4, 24, 110);
    glm::vec3 color = glm::mix(glm::vec3(0.20f, 0.18f, 0.165f), glm::vec3(0.42f, 0.37f, 0.31f),
                               smooth_step(-0.35f, 0.4f, tone));
    color *= 1 + 0.4f * grain;
    const float lichen = smooth_step(0.2f, 0.3f, fbm(p * 7.0f, 5, 7, 120));
    return glm::vec4(glm::mix(color, glm::vec3(0.48f, 0.40f, 0.17f), 0.45f * lichen), 1);
}

glm::vec4 plaster_color(float u, float v) {
    const glm::vec2 p(u, v);
    const float streaks = fbm({u * 24, v * 3}, 4, 0, 130);
    const float tiled =
        glm::mix(streaks, fbm({(u - 1) * 24, v * 3}, 4, 0, 130), smooth_step(0.8f, 1, u));
    const float cloudy = fbm(p * 4.0f, 6, 4, 140);
    const float dirt = smooth_step(0.0f, 0.6f, 0.7f * tiled + 0.5f * cloudy);
    return glm::vec4(
        glm::mix(glm::vec3(0.82f, 0.79f, 0.73f), glm::vec3(0.52f, 0.44f, 0.34f), 0.75f * dirt), 1);
}

// Shallow, overlapping dents of a round hammer.
float hammered_height(float u, float v) {
    const glm::vec2 p = glm::vec2(u, v) * 18.0f;
    const float d = cellular(p, 18, 150).nearest;
    return 0.011f * d * d + 0.0006f * fbm(p, 3, 18, 151);
}

// --- Cloth and leaves ---------------------------------------------------------------------------

// White cloth, tinted by the material: a wheel in a frame and lines of script, frayed at the hem.
glm::vec4 flag_color(float u, float v) {
    const float fray =
        0.02f + 0.05f * smooth_step(0.5f, 1, v) * (0.5f + fbm({u * 26, v * 3}, 3, 0, 160));
    const bool hole = cellular({u * 3 + 0.3f, v * 3}, 0, 161).nearest < 0.055f;
    const float border = std::min(std::min(u, 1 - u), std::min(v, 1 - v));
    const bool cloth = border > fray && !hole;
    const float weave = 0.93f + 0.05f * std::sin(u * 380) * std::sin(v * 380);
    const glm::vec2 from_wheel = glm::vec2(u - 0.5f, v - 0.36f);
    const float r = glm::length(from_wheel), angle = std::atan2(from_wheel.y, from_wheel.x);
    bool ink = std::abs(r - 0.17f) < 0.012f || std::abs(r - 0.13f) < 0.006f || r < 0.035f;
    ink = ink || (r < 0.13f && std::abs(std::sin(4 * angle)) * r < 0.012f);
    ink = ink || std::abs(border - 0.09f) < 0.006f;
    // Script: strokes below a line, as in Tibetan.
    if (v > 0.6f && v < 0.88f && u > 0.14f && u < 0.86f) {
        const float line = std::fmod((v - 0.6f) * 14.0f, 1.0f);
        const auto column = std::uint32_t(u * 34), row = std::uint32_t((v - 0.6f) * 14);
        const float drop = 0.25f + 0.5f * hash_unit(column, row, 162);
        const float across = std::fmod(u * 34, 1.0f);
        ink = ink || (line < 0.14f && hash_unit(column, row, 163) > 0.1f) ||
              (line < drop && across > 0.3f && across < 0.62f);
    }
    const float fade = 0.55f + 0.5f * fbm({u * 6, v * 6}, 4, 0, 164);
    const glm::vec3 color =
        glm::mix(glm::vec3(weave), glm::vec3(0.06f), ink ? std::clamp(fade, 0.2f, 0.9f) : 0.0f);
    return glm::vec4(color, cloth ? 1 : 0);
}

// Base at the bottom, tip at the top.
glm::vec4 leaf_color(float u, float v) {
    const float along = 1 - v, side = std::abs(u - 0.5f);
    const float half_width =
        0.42f * std::pow(std::sin(3.14159f * std::pow(std::clamp(along, 0.0f, 1.0f), 0.8f)), 0.8f);
    const float vein = std::abs(std::fmod(along * 9 - side * 5 + 10, 1.0f) - 0.5f);
    glm::vec3 color =
        glm::mix(glm::vec3(0.05f, 0.12f, 0.025f), glm::vec3(0.10f, 0.20f, 0.04f), along);
    color *= 0.85f + 0.3f * smooth_step(0.5f, 0.42f, vein) + 0.3f * fbm({u * 5, v * 5}, 4, 0, 170);
    if (side < 0.012f) color = glm::vec3(0.22f, 0.27f, 0.09f);
    const bool stalk = along < 0.12f && side < 0.015f;
    return glm::vec4(color, side < half_width || stalk ? 1 : 0);
}

glm::vec4 scarf_color(float u, float v) {
    const float weave = 0.5f + 0.5f * std::sin(u * 700) * std::sin(v * 500);
    const glm::vec2 motif = glm::vec2(std::fmod(u * 4, 1.0f), std::fmod(v * 12, 1.0f)) - 0.5f;
    const float knot =
        smooth_step(0.05f, 0.02f, std::abs(std::abs(motif.x) + std::abs(motif.y) - 0.28f));
    float alpha = 0.42f + 0.12f * weave + 0.4f * knot;
    const float to_end = std::min(v, 1 - v);
    if (to_end < 0.06f) alpha = std::sin(u * 210) > 0.1f ? 0.8f : 0.04f;  // fringes
    if (std::min(u, 1 - u) < 0.03f) alpha = 0.85f;                        // hems
    return glm::vec4(0.86f, 0.83f, 0.76f, alpha);
}

glm::vec4 mist_color(float u, float v) {
    const float up = 1 - v, wisps = fbm({u * 6, v * 2}, 6, 6, 180);
    const float rises = smooth_step(0.0f, 0.12f, up);
    const float thins = 1 - smooth_step(0.25f, 1.0f, up - 0.28f * wisps);
    const float alpha = rises * thins * std::clamp(0.60f + 0.28f * wisps, 0.0f, 1.0f);
    return glm::vec4(0.84f, 0.87f, 0.92f, alpha);
}

}  // namespace

Result<HeroTextures> add_hero_textures(GltfWriter& writer) {
    HeroTextures t{};
    const auto add = [&](int& slot, const char* name, const Picture& picture) -> Result<void> {
        HM_TRY_ASSIGN(slot, writer.add_texture(name, picture));
        return {};
    };
    HM_TRY(add(t.slab_color, "slab color", paint(1024, 1024, 3, slab_color)));
    HM_TRY(add(t.slab_normal, "slab normal", paint_normals(768, slab_height)));
    HM_TRY(add(t.slab_roughness, "slab roughness", paint_slab_roughness(512)));
    HM_TRY(add(t.rock_color, "rock color", paint(512, 512, 3, rock_color)));
    HM_TRY(add(t.rock_normal, "rock normal", paint_normals(384, rock_height)));
    HM_TRY(add(t.plaster_color, "plaster color", paint(512, 512, 3, plaster_color)));
    HM_TRY(add(t.hammered_normal, "hammered normal", paint_normals(512, hammered_height)));
    HM_TRY(add(t.flag_color, "flag color", paint(256, 256, 4, flag_color)));
    HM_TRY(add(t.leaf_color, "leaf color", paint(128, 256, 4, leaf_color)));
    HM_TRY(add(t.scarf_color, "scarf color", paint(256, 512, 4, scarf_color)));
    HM_TRY(add(t.mist_color, "mist color", paint(512, 128, 4, mist_color)));
    return t;
}

}  // namespace hm
