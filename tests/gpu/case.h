// What a parity topic (cases_<topic>.h) is made of; GLSL and C++ at once, as the files it tests.
//
// A topic defines
//     HM_FN void run_case(uint index, HM_OUT(CaseResult) result)
// between HM_CASES_BEGIN(values, choices) and HM_CASES_END. It draws its arguments from the case's
// index by the functions below, which give both sides the same bits, calls the shared code, and
// fills
//     values   continuous results, compared by relative difference,
//     choices  discrete ones, compared for equality.
// The two numbers are the arrays' sizes, at least 1.
#ifndef HM_TESTS_GPU_CASE_H
#define HM_TESTS_GPU_CASE_H

#include "shading/math.h"
#include "shading/rng.h"

#define HM_CASES_BEGIN(value_count, choice_count) \
    HM_NAMESPACE_BEGIN                            \
    HM_CONST uint kValues = value_count;          \
    HM_CONST uint kChoices = choice_count;        \
    struct CaseResult {                           \
        float values[kValues];                    \
        uint choices[kChoices];                   \
    };
#define HM_CASES_END HM_NAMESPACE_END

// The same for a topic that calls the stages, which see their tables: in C++ it is the body of a
// PathTracer (path_tracer.h).
#ifdef __cplusplus
#define HM_STAGE_CASES_BEGIN(value_count, choice_count) \
    HM_CASES_BEGIN(value_count, choice_count)           \
    struct StageCases : test::PathTracer {              \
        using PathTracer::PathTracer;
#define HM_STAGE_CASES_END \
    }                      \
    ;                      \
    HM_CASES_END
#else
#define HM_STAGE_CASES_BEGIN(value_count, choice_count) HM_CASES_BEGIN(value_count, choice_count)
#define HM_STAGE_CASES_END HM_CASES_END
#endif

#ifdef __cplusplus
#include <vector>
#define HM_PRECISE
#else
#define HM_PRECISE precise
#endif

HM_NAMESPACE_BEGIN

// Normalising is rounded differently from device to device, so the host makes the unit vectors.
HM_CONST uint kDirections = 65536u;
#ifdef __cplusplus
extern const std::vector<vec3> case_directions;
#else
layout(scalar, set = 0, binding = 1) readonly buffer Directions {
    vec3 case_directions[];
};
#endif

// The case's argument number `which`, as any integer.
HM_FN uint case_bits(uint index, uint which) {
    return hash_combine(index, which);
}

// As a uniform number in [0, 1).
HM_FN float case_unit(uint index, uint which) {
    return unit_float(case_bits(index, which));
}

// In [low, high].
HM_FN float case_between(uint index, uint which, float low, float high) {
    HM_PRECISE float scaled = (high - low) * case_unit(index, which);
    HM_PRECISE float value = low + scaled;
    return value;
}

// A unit vector, uniform over the sphere.
HM_FN vec3 case_direction(uint index, uint which) {
    return case_directions[mul_high(case_bits(index, which), kDirections)];
}

// The same in the upper hemisphere.
HM_FN vec3 case_upper_direction(uint index, uint which) {
    vec3 direction = case_direction(index, which);
    return vec3(direction.x, direction.y, abs(direction.z));
}

HM_NAMESPACE_END

#endif
