#include "hero_terrain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "noise.h"

namespace hm {
namespace {

constexpr float kHalfAngle = 0.64f;  // radians to either side of -z: more than the picture shows
constexpr float kNear = 45;          // metres from the terrace
constexpr float kPeaksFrom = 1000;
constexpr float kFar = 2400;
constexpr float kNearShare = 0.25f;  // of the rows: geometric spacing up to kPeaksFrom, then even

struct Peak {
    glm::vec2 xz;
    float height;
    float radius;
    float ridges;  // phase of its ridges, radians
};

// One dominant pyramid left of the centre, its shoulder, and a lower range on either side.
constexpr std::array kPeaks = {
    Peak{{-370, -1960}, 735, 1250, 0.4f}, Peak{{40, -2150}, 520, 820, 1.7f},
    Peak{{-1050, -1850}, 500, 800, 2.6f}, Peak{{430, -2050}, 560, 800, 0.9f},
    Peak{{900, -1900}, 660, 950, 2.2f},
};

float range_height(glm::vec2 xz) {
    const glm::vec2 warp(fbm(xz / 500.0f, 4, 0, 200), fbm(xz / 500.0f, 4, 0, 210));
    const glm::vec2 p = xz + 110.0f * warp;
    float envelope = 0;
    for (const Peak& peak : kPeaks) {
        const glm::vec2 d = p - peak.xz;
        const float angle = std::atan2(d.y, d.x), distance = glm::length(d) / peak.radius;
        // Ridges: contour lines are star-shaped, and rounder towards the foot.
        const float star = 1 + (0.16f * std::sin(3 * angle + peak.ridges) +
                                0.07f * std::sin(7 * angle + 2 * peak.ridges)) *
                                   std::exp(-2 * distance);
        const float reach = std::max(0.0f, 1 - distance / star);
        envelope =
            std::max(envelope, peak.height * (0.55f * reach + 0.45f * reach * reach * reach));
    }
    const float crests = ridged(p / 380.0f, 8, 220), flutes = ridged(p / 95.0f, 5, 240);
    return envelope * (0.86f + 0.30f * (crests - 0.4f)) + 130 * (crests - 0.35f) +
           0.035f * envelope * (flutes - 0.4f);
}

// Forested spurs on both sides of the valley.
float spur_height(float azimuth, float distance, glm::vec2 xz) {
    const auto spur = [&](float at_azimuth, float width, float at_distance, float depth,
                          float top) {
        const float a = (azimuth - at_azimuth) / width, d = (distance - at_distance) / depth;
        return top * std::exp(-a * a - d * d);
    };
    const float height = spur(-0.62f, 0.26f, 420, 230, 215) + spur(0.50f, 0.22f, 560, 260, 205) +
                         spur(0.04f, 0.14f, 800, 160, 95);
    return height * (0.85f + 0.35f * ridged(xz / 160.0f, 6, 260));
}

glm::vec2 position_at(float s, float t) {
    const float azimuth = kHalfAngle * (2 * s - 1);
    const float near_t = t / kNearShare, far_t = (t - kNearShare) / (1 - kNearShare);
    const float r = t < kNearShare ? kNear * std::pow(kPeaksFrom / kNear, near_t)
                                   : kPeaksFrom + (kFar - kPeaksFrom) * far_t;
    return {r * std::sin(azimuth), -r * std::cos(azimuth)};
}

glm::vec3 normal_at(glm::vec2 xz, float step) {
    const float dx =
        terrain_height(xz + glm::vec2(step, 0)) - terrain_height(xz - glm::vec2(step, 0));
    const float dz =
        terrain_height(xz + glm::vec2(0, step)) - terrain_height(xz - glm::vec2(0, step));
    return glm::normalize(glm::vec3(-dx, 2 * step, -dz));
}

// Snow where the ground is high and not too steep; scree, forest and meadow below.
glm::vec3 ground_color(glm::vec2 xz) {
    const float distance = glm::length(xz), h = terrain_height(xz);
    const glm::vec3 n = normal_at(xz, distance < kPeaksFrom ? 3.0f : 4.0f);
    const float mottle = fbm(xz / 40.0f, 5, 0, 280);
    const float strata = fbm({(xz.x + xz.y) / 300.0f, h / 14.0f}, 4, 0, 285);
    glm::vec3 rock = glm::mix(glm::vec3(0.115f, 0.10f, 0.095f), glm::vec3(0.25f, 0.205f, 0.175f),
                              smooth_step(-0.4f, 0.4f, strata + 0.5f * mottle));
    glm::vec3 low = glm::mix(glm::vec3(0.022f, 0.038f, 0.020f), glm::vec3(0.09f, 0.085f, 0.035f),
                             smooth_step(-0.1f, 0.35f, mottle + 0.3f * n.y - 0.1f));
    const float steep = smooth_step(0.66f, 0.48f, n.y + 0.12f * mottle);
    low = glm::mix(low, rock, steep);
    const float above_trees = smooth_step(40, 130, h + 50 * mottle);
    glm::vec3 color = glm::mix(low, rock, above_trees);
    const float cover = smooth_step(30, 150, h + 70 * mottle);
    const float holds = smooth_step(0.30f, 0.50f, n.y + 0.16f * fbm(xz / 25.0f, 5, 0, 290));
    color = glm::mix(color, glm::vec3(0.87f, 0.88f, 0.91f), cover * holds);
    // Aerial perspective: distant ground is paler and bluer.
    const float air = 1 - std::exp(-distance / 9000);
    return glm::mix(color, glm::vec3(0.55f, 0.60f, 0.70f), air);
}

}  // namespace

float terrain_height(glm::vec2 xz) {
    const float distance = glm::length(xz), azimuth = std::atan2(xz.x, -xz.y);
    const float valley = -175 + 22 * fbm(xz / 150.0f, 6, 0, 300);
    const float slope = glm::mix(-14.0f, valley, smooth_step(30, 330, distance));
    return slope + spur_height(azimuth, distance, xz) +
           range_height(xz) * smooth_step(700, 1250, distance);
}

TriangleMesh make_terrain() {
    constexpr int kColumns = 320, kRows = 150;
    TriangleMesh mesh = make_surface(kColumns, kRows, [](float s, float t) {
        const glm::vec2 xz = position_at(s, t);
        return SurfacePoint{{xz.x, terrain_height(xz), xz.y}, {s, 1 - t}};
    });
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec2 xz(mesh.positions[i].x, mesh.positions[i].z);
        mesh.normals[i] = normal_at(xz, glm::length(xz) < kPeaksFrom ? 4.0f : 5.0f);
    }
    return mesh;
}

Picture paint_terrain() {
    Picture picture{1024, 512, 3, {}};
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const float s = (float(x) + 0.5f) / float(picture.width);
            const float t = 1 - (float(y) + 0.5f) / float(picture.height);
            const glm::vec3 c = glm::clamp(ground_color(position_at(s, t)), 0.0f, 1.0f);
            for (int i = 0; i < 3; ++i) {
                const float encoded =
                    1.055f * std::pow(std::max(c[i], 0.0031308f), 1 / 2.4f) - 0.055f;
                picture.pixels.push_back(std::uint8_t(encoded * 255 + 0.5f));
            }
        }
    return picture;
}

std::vector<glm::vec4> place_trees(int count) {
    std::vector<glm::vec4> trees;
    for (std::uint32_t i = 0; int(trees.size()) < count && i < 40000; ++i) {
        const float azimuth = kHalfAngle * 0.95f * (2 * hash_unit(i, 0, 310) - 1);
        const float distance = 60 + 640 * std::pow(hash_unit(i, 1, 310), 0.8f);
        const glm::vec2 xz(distance * std::sin(azimuth), -distance * std::cos(azimuth));
        const float h = terrain_height(xz);
        const float grove = fbm(xz / 60.0f, 3, 0, 311);
        if (h < -120 || h > 105 || grove < -0.14f || normal_at(xz, 4).y < 0.42f) continue;
        trees.push_back({xz.x, h - 0.4f, xz.y, 0.7f + 0.7f * hash_unit(i, 2, 310)});
    }
    return trees;
}

}  // namespace hm
