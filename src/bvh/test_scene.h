// Triangles, rays and reference intersectors shared by the BVH tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "bvh/bvh.h"
#include "bvh/trace_batch.h"

namespace hm::bvh_test {

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Random {
    std::uint64_t state;
    std::uint32_t bits() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return std::uint32_t(state >> 32);
    }
    float unit() { return float(bits() >> 8) * 0x1p-24f; }
    float between(float a, float b) { return a + (b - a) * unit(); }
    vec3 in_cube(float half) {
        const float x = between(-half, half);
        const float y = between(-half, half);
        const float z = between(-half, half);
        return {x, y, z};
    }
    vec3 direction() {
        for (;;) {
            const vec3 v = in_cube(1);
            if (const float l = dot(v, v); l > 0.01f && l < 1) return v / std::sqrt(l);
        }
    }
};

// Vertices and triangles of one geometry; spans into it stay valid until it is modified.
struct Soup {
    std::vector<Vertex> vertices;
    std::vector<uvec3> triangles;

    void add(vec3 a, vec3 b, vec3 c) {
        const auto first = std::uint32_t(vertices.size());
        for (const vec3& p : {a, b, c})
            add_vertex(p);
        triangles.push_back({first, first + 1, first + 2});
    }
    void add_vertex(vec3 p) {
        Vertex v{};
        v.position = p;
        vertices.push_back(v);
    }
    vec3 corner(std::size_t triangle, int i) const {
        return vertices[triangles[triangle][std::size_t(i)]].position;
    }
    BvhGeometry geometry(bool opaque = true) const { return {vertices, triangles, opaque}; }
};

inline Soup random_soup(Random& random, int count, float half, float size) {
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const vec3 p = random.in_cube(half);
        const vec3 q = p + random.in_cube(size);
        const vec3 r = p + random.in_cube(size);
        soup.add(p, q, r);
    }
    return soup;
}

inline Bvh build_one(const Soup& soup, bool opaque = true) {
    const std::vector<BvhMesh> meshes{{{soup.geometry(opaque)}}};
    const std::vector<BvhInstance> instances{{0, mat4x3(1), mat4x3(1)}};
    return build_bvh(meshes, instances);
}

struct Traced {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> found;
    std::uint64_t accept_calls = 0;
};

inline Traced trace(const TraceVariant& variant, const Bvh& bvh, const std::vector<Ray>& rays,
                    bool any = false, std::uint32_t accept = kAcceptAll) {
    Traced result{std::vector<Hit>(rays.size()), std::vector<std::uint8_t>(rays.size()), 0};
    const BvhView view = bvh.view();
    TraceBatch batch{
        &view, rays.data(), result.hits.data(), result.found.data(), rays.size(), accept, 0};
    any ? variant.any(batch) : variant.closest(batch);
    result.accept_calls = batch.accept_calls;
    return result;
}

// Traces with every variant, expects bit-identical results and that any-hit finds a hit exactly
// where closest-hit does, and returns the common result.
inline Traced trace_all(const Bvh& bvh, const std::vector<Ray>& rays,
                        std::uint32_t accept = kAcceptAll) {
    const Traced first = trace(trace_variants()[0], bvh, rays, false, accept);
    for (const TraceVariant& variant : trace_variants()) {
        const Traced closest = trace(variant, bvh, rays, false, accept);
        EXPECT_EQ(first.found, closest.found) << variant.name;
        EXPECT_EQ(0, std::memcmp(first.hits.data(), closest.hits.data(), rays.size() * sizeof(Hit)))
            << variant.name;
        const Traced any = trace(variant, bvh, rays, true, accept);
        EXPECT_EQ(first.found, any.found) << variant.name << ", any hit";
    }
    return first;
}

// Möller-Trumbore in double precision; `margin` is the smallest barycentric weight, i.e. how far
// inside the triangle the hit lies (negative: outside).
struct DoubleHit {
    double t, u, v, margin;
};

inline std::optional<DoubleHit> intersect_double(const glm::dvec3& a, const glm::dvec3& b,
                                                 const glm::dvec3& c, const glm::dvec3& origin,
                                                 const glm::dvec3& direction) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 p = glm::cross(direction, ac);
    const double det = glm::dot(ab, p);
    if (det == 0) return std::nullopt;
    const glm::dvec3 s = origin - a;
    const double u = glm::dot(s, p) / det;
    const glm::dvec3 q = glm::cross(s, ab);
    const double v = glm::dot(direction, q) / det;
    const double t = glm::dot(ac, q) / det;
    return DoubleHit{t, u, v, std::min({u, v, 1 - u - v})};
}

}  // namespace hm::bvh_test
