// Hashes: PCG as an integer hash and its four-wide sibling (Jarzynski and Olano, "Hash Functions
// for GPU Rendering", JCGT 2020), and hash-based Owen scrambling (Laine and Karras 2011; Burley,
// "Practical Hash-based Owen Scrambling", JCGT 2020; constants by Vegdahl 2021).
#ifndef HM_SHADING_RNG_H
#define HM_SHADING_RNG_H

#include "shading/lang.h"

HM_NAMESPACE_BEGIN

HM_FN uint pcg_hash(uint x) {
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// Order matters: hash_combine(a, b) != hash_combine(b, a).
HM_FN uint hash_combine(uint hash, uint value) {
    return pcg_hash(hash ^ pcg_hash(value));
}

HM_FN uvec4 pcg4d_hash(uvec4 x) {
    uvec4 v = x * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v = v ^ (v >> 16u);
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Owen scrambling of a number whose bits are reversed: a bit is flipped by a hash of the bits below
// it, that is, of the more significant digits of the number before the reversal.
HM_FN uint owen_scramble_reversed(uint x, uint seed) {
    x = x ^ (x * 0x3d20adeau);
    x = x + seed;
    x = x * ((seed >> 16u) | 1u);
    x = x ^ (x * 0x05526c56u);
    x = x ^ (x * 0x53a22864u);
    return x;
}

HM_NAMESPACE_END

#endif
