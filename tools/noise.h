// Procedural noise for textures and terrain, from integer hashes and so the same on every machine.
// `period` is in lattice cells (0: the noise does not repeat).
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace hm {

std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

// Uniform in 0..1 from a hash.
float hash_unit(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

// Perlin's gradient noise, about -1..1, mean 0.
float gradient_noise(glm::vec2 p, int period, std::uint32_t seed);

// Fractal sum of gradient noise: octaves of twice the frequency, half the amplitude; about -1..1.
float fbm(glm::vec2 p, int octaves, int period, std::uint32_t seed);

// Musgrave's ridged multifractal: sharp crests with fine detail, 0..1.
float ridged(glm::vec2 p, int octaves, std::uint32_t seed);

// Worley's cellular noise: distances to the nearest and second nearest feature point.
struct Cell {
    float nearest = 0;
    float second = 0;
    std::uint32_t id = 0;
};
Cell cellular(glm::vec2 p, int period, std::uint32_t seed);

float smooth_step(float low, float high, float x);

}  // namespace hm
