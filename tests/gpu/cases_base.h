// Parity of hashes, elementary functions, warps and frames.
#include "gpu/case.h"
#include "shading/frame.h"
#include "shading/warp.h"

HM_CASES_BEGIN(18, 5)

HM_FN void run_case(uint index, HM_OUT(CaseResult) result) {
    float u = case_unit(index, 0u);
    float v = case_unit(index, 1u);
    uint bits = case_bits(index, 2u);

    uvec4 hashed = pcg4d_hash(uvec4(index, bits, 3u, 4u));
    result.choices[0] = hash_combine(index, bits);
    result.choices[1] = hashed.x ^ hashed.y ^ hashed.z ^ hashed.w;
    result.choices[2] = owen_scramble_reversed(reverse_bits(index), bits);
    result.choices[3] = mul_high(bits, 12345u);
    result.choices[4] = float_bits(unit_float(bits));

    vec2 turn = cos_sin_2pi(u);
    result.values[0] = turn.x;
    result.values[1] = turn.y;
    vec3 direction = case_direction(index, 3u);
    result.values[2] = atan2_over_2pi(direction.y, direction.x);
    result.values[3] = mis_weight(0.01f + u, 4.0f * v);
    result.values[4] = pow5(u);

    vec2 disk = sample_disk(u, v);
    vec3 hemisphere = sample_cosine_hemisphere(u, v);
    vec2 triangle = sample_triangle(u, v);
    result.values[5] = disk.x;
    result.values[6] = disk.y;
    result.values[7] = hemisphere.z;
    result.values[8] = pdf_cosine_hemisphere(hemisphere.z);
    result.values[9] = triangle.x;
    result.values[10] = triangle.y;

    Frame frame;
    make_frame(direction, frame);
    vec3 other = case_direction(index, 4u);
    vec3 local = to_local(frame, other);
    vec3 world = to_world(frame, other);
    result.values[11] = local.x;
    result.values[12] = local.y;
    result.values[13] = local.z;
    result.values[14] = world.x;
    result.values[15] = world.y;
    result.values[16] = world.z;
    result.values[17] = luminance(abs(other));
}

HM_CASES_END
