#include "hero_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/write.h"
#include "noise.h"

namespace hm {
namespace {

constexpr std::uint32_t kWidth = 1024;
constexpr std::uint32_t kHeight = 512;
constexpr float kPi = std::numbers::pi_v<float>;

// Blue overhead, pale at the horizon, warm towards the sun, rose opposite it.
glm::vec3 clear_sky(glm::vec3 d) {
    const float up = std::max(d.y, 0.0f), to_sun = glm::dot(d, hero_sun_direction());
    const float haze = std::exp(-8.0f * up);
    const glm::vec3 zenith(0.085f, 0.18f, 0.42f), pale(0.36f, 0.50f, 0.72f);
    glm::vec3 color = glm::mix(zenith, pale, std::exp(-2.6f * up));
    const float sunward = 0.5f + 0.5f * to_sun;
    const glm::vec3 rose(0.60f, 0.47f, 0.49f), gold(1.25f, 0.80f, 0.42f);
    color = glm::mix(color, glm::mix(rose, gold, std::pow(sunward, 1.6f)), haze * 0.85f);
    const float angle = std::acos(std::clamp(to_sun, -1.0f, 1.0f));
    color += glm::vec3(1.0f, 0.72f, 0.40f) *
             (3.0f * std::exp(-angle / 0.07f) + 0.9f * std::exp(-angle / 0.30f));
    return color;
}

// Thin, elongated clouds on a plane overhead, lit from the direction of the sun.
glm::vec3 add_clouds(glm::vec3 sky, glm::vec3 d) {
    if (d.y < 0.02f) return sky;
    const glm::vec2 p = glm::vec2(d.x, d.z) / (d.y + 0.16f);
    const glm::vec2 drawn(1.1f * p.x + 0.5f * p.y, 2.6f * p.y - 0.6f * p.x);
    const glm::vec2 warp(fbm(drawn, 4, 0, 400), fbm(drawn, 4, 0, 410));
    const float density = fbm(drawn * 0.9f + 1.3f * warp, 7, 0, 420);
    const float cover = smooth_step(0.02f, 0.42f, density) * smooth_step(0.02f, 0.16f, d.y);
    const float sunward = 0.5f + 0.5f * glm::dot(d, hero_sun_direction());
    const glm::vec3 lit =
        glm::mix(glm::vec3(0.78f, 0.60f, 0.60f), glm::vec3(1.7f, 1.15f, 0.72f), sunward * sunward);
    return glm::mix(sky, lit, 0.75f * cover);
}

glm::vec3 radiance(glm::vec3 d) {
    const glm::vec3 ground = glm::vec3(0.16f, 0.14f, 0.13f);
    const glm::vec3 sky = add_clouds(clear_sky(d), d);
    return glm::mix(ground, sky, smooth_step(-0.06f, 0.0f, d.y));
}

}  // namespace

glm::vec3 hero_sun_direction() {
    return glm::normalize(glm::vec3(-0.90f, 0.31f, 0.17f));
}

Result<void> write_hero_sky(const std::filesystem::path& path) {
    FloatImage image(kWidth, kHeight);
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const float azimuth = 2 * kPi * ((float(x) + 0.5f) / float(kWidth) - 0.5f);
            const float polar = kPi * (float(y) + 0.5f) / float(kHeight);
            const float s = std::sin(polar);
            const glm::vec3 c =
                radiance({s * std::cos(azimuth), std::cos(polar), s * std::sin(azimuth)});
            image.pixels[y * kWidth + x] = {c.x, c.y, c.z, 1};
        }
    return write_hdr(path, image);
}

}  // namespace hm
