#include "noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hm {
namespace {

std::uint32_t wrapped(int cell, int period) {
    return std::uint32_t(period == 0 ? cell : ((cell % period) + period) % period);
}

float corner(glm::vec2 p, glm::ivec2 cell, int period, std::uint32_t seed) {
    const float turn = hash_unit(wrapped(cell.x, period), wrapped(cell.y, period), seed);
    const float angle = 2 * std::numbers::pi_v<float> * turn;
    return glm::dot(p - glm::vec2(cell), glm::vec2(std::cos(angle), std::sin(angle)));
}

}  // namespace

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b9u + 0x7f4a7c15u;
    for (const std::uint32_t word : {x, y}) {
        h ^= word;
        h *= 0x85ebca6bu;
        h ^= h >> 15;
        h *= 0xc2b2ae35u;
        h ^= h >> 13;
    }
    return h;
}

float hash_unit(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    return float(hash(x, y, seed) >> 8) * 0x1p-24f;
}

float gradient_noise(glm::vec2 p, int period, std::uint32_t seed) {
    const glm::ivec2 cell(int(std::floor(p.x)), int(std::floor(p.y)));
    const glm::vec2 f = p - glm::vec2(cell);
    const glm::vec2 w = f * f * f * (f * (f * 6.0f - 15.0f) + 10.0f);
    const float top = glm::mix(corner(p, cell, period, seed),
                               corner(p, cell + glm::ivec2(1, 0), period, seed), w.x);
    const float bottom = glm::mix(corner(p, cell + glm::ivec2(0, 1), period, seed),
                                  corner(p, cell + glm::ivec2(1, 1), period, seed), w.x);
    return 1.5f * glm::mix(top, bottom, w.y);
}

float fbm(glm::vec2 p, int octaves, int period, std::uint32_t seed) {
    float sum = 0, amplitude = 0.5f;
    for (int i = 0; i < octaves; ++i) {
        sum += amplitude * gradient_noise(p, period, seed + std::uint32_t(i));
        p *= 2.0f;
        period *= 2;
        amplitude *= 0.5f;
    }
    return sum;
}

float ridged(glm::vec2 p, int octaves, std::uint32_t seed) {
    float sum = 0, amplitude = 0.5f, weight = 1;
    for (int i = 0; i < octaves; ++i) {
        const float n = gradient_noise(p, 0, seed + std::uint32_t(i));
        const float crest = std::pow(1 - std::min(std::abs(n), 1.0f), 2.0f) * weight;
        weight = std::clamp(1.8f * crest, 0.0f, 1.0f);
        sum += amplitude * crest;
        amplitude *= 0.5f;
        // Rotated by the angle of the 3-4-5 triangle, so that octaves share no axis.
        p = 2.03f * glm::vec2(0.8f * p.x - 0.6f * p.y, 0.6f * p.x + 0.8f * p.y);
    }
    return sum;
}

Cell cellular(glm::vec2 p, int period, std::uint32_t seed) {
    const glm::ivec2 home(int(std::floor(p.x)), int(std::floor(p.y)));
    Cell result{8, 8, 0};
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const glm::ivec2 cell = home + glm::ivec2(x, y);
            const std::uint32_t cx = wrapped(cell.x, period), cy = wrapped(cell.y, period);
            const glm::vec2 point =
                glm::vec2(cell) + glm::vec2(hash_unit(cx, cy, seed), hash_unit(cx, cy, seed + 1));
            const float distance = glm::length(point - p);
            if (distance < result.nearest) {
                result.second = result.nearest;
                result.nearest = distance;
                result.id = hash(cx, cy, seed + 2);
            } else {
                result.second = std::min(result.second, distance);
            }
        }
    return result;
}

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

}  // namespace hm
