// Random sequences. Four dimensions at a time, as 32-bit integers: integers can reach every entry
// of a table, unit_float converts them to floats. Dimensions: 0-1 pixel, 2-3 lens, 4 time, 5-7
// kept; bounce b has 8 + 8b: lobe, BSDF u v, roulette | light choice, alias coin, light u v. From
// dimension 128 on every sampler is PCG keyed by (pixel, sample, dimension).
//
// Tables: sobol_directions[128 * 32], sobol_nibbles[8 * 16], blue_noise[128 * 128].

HM_CONST uint kSobolDimensions = 128u;
HM_CONST uint kDimensionPixel = 0u;
HM_CONST uint kDimensionBounce = 8u;

struct SamplerState {
    uint pixel_x;
    uint pixel_y;
    uint index;
    uint index_reversed;
    uint key;  // hash of pixel and seed
#ifdef HM_AOVS
    uint replicate;
#endif
};

// Fills what follows from pixel, index and replicate.
HM_FN void key_sample(HM_INOUT(SamplerState) s) {
    s.key = hash_combine(params.seed, s.pixel_x | (s.pixel_y << 16u));
#ifdef HM_AOVS
    if (aovs.replicates > 1u) s.key = hash_combine(s.key, s.replicate);
#endif
    s.index_reversed = reverse_bits(s.index);
}

HM_FN void begin_sample(uint pixel_x, uint pixel_y, uint index, HM_OUT(SamplerState) s) {
    s.pixel_x = pixel_x;
    s.pixel_y = pixel_y;
    s.index = index;
#ifdef HM_AOVS
    // For the variance: each replicate is a sequence of its own, randomised on its own.
    s.replicate = 0u;
    if (aovs.replicates > 1u) {
        s.replicate = index % aovs.replicates;
        s.index = index / aovs.replicates;
    }
#endif
    key_sample(s);
}

// The state that the path began with, from what its payload keeps of it.
HM_FN void resume_sample(HM_IN(PathPayload) p, HM_OUT(SamplerState) s) {
    s.pixel_x = p.pixel & 65535u;
    s.pixel_y = p.pixel >> 16u;
    s.index = p.index;
#ifdef HM_AOVS
    s.replicate = p.replicate;
#endif
    key_sample(s);
}

// Sobol (Joe and Kuo 2008), direction numbers with the most significant bit first.
HM_FN uint sobol_number(uint dimension, uint index) {
    uint x = 0u;
    uint row = dimension * 32u;
    for (uint rest = index; rest != 0u; rest = rest >> 1u) {
        if ((rest & 1u) != 0u) x = x ^ sobol_directions[row];
        row = row + 1u;
    }
    return x;
}

// A Cranley-Patterson rotation of Sobol by a blue-noise tile, displaced per dimension, and by the
// golden ratio times the seed. The offset must not depend on the sample index.
HM_FN uint sample_sobol_blue_noise(HM_IN(SamplerState) s, uint dimension) {
    uint x = (s.pixel_x + dimension * 73u) & 127u;
    uint y = (s.pixel_y + dimension * 127u) & 127u;
    uint offset = (blue_noise[y * 128u + x] << 18u) + 0x00020000u + params.seed * 0x9e3779b9u;
#ifdef HM_AOVS
    if (aovs.replicates > 1u)
        offset = offset + hash_combine(hash_combine(params.seed, s.replicate), dimension);
#endif
    return sobol_number(dimension, s.index) + offset;
}

// Four-dimensional Sobol points per group of four dimensions, index shuffled and digits scrambled
// by hashes (Burley 2020). The nibble tables map reversed indices to reversed Sobol numbers.
HM_FN uvec4 sample_sobol_owen(HM_IN(SamplerState) s, uint dimension) {
    uvec4 seeds = pcg4d_hash(uvec4(s.key, dimension, 0x68bc21ebu, 0x02e5be93u));
    uint i = owen_scramble_reversed(s.index_reversed, seeds.x ^ seeds.z);
    uvec4 x = sobol_nibbles[i & 15u];
    for (uint digit = 1u; digit < 8u; ++digit)
        x = x ^ sobol_nibbles[digit * 16u + ((i >> (4u * digit)) & 15u)];
    x.x = reverse_bits(owen_scramble_reversed(x.x, seeds.x));
    x.y = reverse_bits(owen_scramble_reversed(x.y, seeds.y));
    x.z = reverse_bits(owen_scramble_reversed(x.z, seeds.z));
    x.w = reverse_bits(owen_scramble_reversed(x.w, seeds.w));
    return x;
}

// The sample's numbers in `dimension` to `dimension` + 3; `dimension` is a multiple of four.
HM_FN uvec4 sample_4d(HM_IN(SamplerState) s, uint dimension) {
    if (params.sampler_kind == kSamplerIndependent || dimension >= kSobolDimensions)
        return pcg4d_hash(uvec4(s.key, s.index, dimension, params.seed));
    if (params.sampler_kind == kSamplerSobolOwen) return sample_sobol_owen(s, dimension);
    uvec4 x;
    x.x = sample_sobol_blue_noise(s, dimension);
    x.y = sample_sobol_blue_noise(s, dimension + 1u);
    x.z = sample_sobol_blue_noise(s, dimension + 2u);
    x.w = sample_sobol_blue_noise(s, dimension + 3u);
    return x;
}
