// Arithmetic that GLSL does not specify to the bit, with the results of C++: quotients and roots may
// be off by units in the last place, dot products may sum in any order. Which branch a path takes can
// depend on such a bit, and differences grow with every bounce; so everything that decides where a
// ray goes uses these functions, and a GPU traces the paths of the CPU. Contraction of a * b + c is
// forbidden by cmake/Shaders.cmake.

// Whether quotients and roots are correctly rounded as they are: the device is a CPU. On a GPU fma
// rounds once (on a CPU it need not), so the residual of a quotient or root that fma gives is exact
// and corrects it (Markstein, "Computation of elementary functions on the IBM RISC System/6000 processor",
// 1990). rhi/pipeline sets it.
layout(constant_id = 0) const bool kRoundsRight = false;

float divide(float a, float b) {
    if (kRoundsRight) return a / b;
    precise float r = 1.0f / b;
    precise float near = a * r;
    precise float quotient = fma(fma(-b, near, a), r, near);
    return quotient;
}

float exact_sqrt(float x) {
    if (kRoundsRight) return sqrt(x);
    float r = inversesqrt(x);
    precise float near = x * r;
    precise float root = fma(fma(-near, near, x), 0.5f * r, near);
    return x > 0.0f ? root : x;
}

float exact_inversesqrt(float x) {
    return divide(1.0f, exact_sqrt(x));
}

float exact_dot(vec2 a, vec2 b) {
    return a.x * b.x + a.y * b.y;
}

float exact_dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

vec3 exact_cross(vec3 a, vec3 b) {
    return vec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
}

vec3 exact_normalize(vec3 v) {
    return v * exact_inversesqrt(exact_dot(v, v));
}

// The device's own functions, for what only weights a path.
float fast_sqrt(float x) {
    return sqrt(x);
}

vec3 fast_normalize(vec3 v) {
    return normalize(v);
}

// glslang does not accept functions that have the name of a built-in one.
#define sqrt exact_sqrt
#define inversesqrt exact_inversesqrt
#define dot exact_dot
#define cross exact_cross
#define normalize exact_normalize
