// Rays aimed from inside a closed mesh at its shared edges and vertices never leak out.
#include "bvh/test_scene.h"

namespace hm::bvh_test {
namespace {

Soup sphere(std::uint32_t rings, std::uint32_t sectors, vec3 centre, float radius) {
    Soup soup;
    soup.add_vertex(centre + vec3(0, radius, 0));
    for (std::uint32_t r = 1; r < rings; ++r)
        for (std::uint32_t s = 0; s < sectors; ++s) {
            const float theta = std::numbers::pi_v<float> * float(r) / float(rings);
            const float phi = 2 * std::numbers::pi_v<float> * float(s) / float(sectors);
            soup.add_vertex(centre + radius * vec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                                                   std::sin(theta) * std::sin(phi)));
        }
    soup.add_vertex(centre - vec3(0, radius, 0));
    const auto at = [&](std::uint32_t r, std::uint32_t s) { return 1 + r * sectors + s % sectors; };
    const auto last = std::uint32_t(soup.vertices.size() - 1);
    for (std::uint32_t s = 0; s < sectors; ++s) {
        soup.triangles.push_back({0, at(0, s), at(0, s + 1)});
        for (std::uint32_t r = 0; r + 2 < rings; ++r) {
            soup.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            soup.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
        soup.triangles.push_back({last, at(rings - 2, s), at(rings - 2, s + 1)});
    }
    return soup;
}

// A cube with side length 2 * half; its faces share the vertices on the edges.
Soup cube(int cells, vec3 centre, float half) {
    Soup soup;
    const int n = cells + 1;
    std::vector<std::uint32_t> index(std::size_t(n) * std::size_t(n) * std::size_t(n), kNone);
    const auto at = [&](glm::ivec3 p) {
        std::uint32_t& i = index[std::size_t((p.x * n + p.y) * n + p.z)];
        if (i == kNone) {
            i = std::uint32_t(soup.vertices.size());
            soup.add_vertex(centre + half * (2.0f * vec3(p) / float(cells) - 1.0f));
        }
        return i;
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const int side : {0, cells})
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const auto corner = [&](int di, int dj) {
                        glm::ivec3 p(0);
                        p[axis] = side;
                        p[(axis + 1) % 3] = i + di;
                        p[(axis + 2) % 3] = j + dj;
                        return at(p);
                    };
                    soup.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
                    soup.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
                }
    return soup;
}

// Rays from inside towards vertices, edge midpoints and random points on edges.
std::vector<Ray> rays_from_inside(const Soup& soup, Random& random, int count, vec3 centre,
                                  float half) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const std::size_t k = random.bits() % soup.triangles.size();
        const vec3 a = soup.corner(k, 0);
        const vec3 b = soup.corner(k, 1);
        const vec3 origin = i % 8 == 0 ? centre : centre + random.in_cube(half);
        const vec3 target = i % 3 == 0 ? a : mix(a, b, i % 3 == 1 ? 0.5f : random.unit());
        rays.push_back({origin, target - origin, kInfinity});
    }
    return rays;
}

void expect_no_leak(const Soup& soup, const std::vector<Ray>& rays) {
    const Traced traced = trace_all(build_one(soup), rays);
    for (std::size_t i = 0; i < rays.size(); ++i)
        ASSERT_NE(traced.found[i], 0)
            << "ray " << i << " from " << rays[i].origin.x << " " << rays[i].origin.y << " "
            << rays[i].origin.z << " along " << rays[i].direction.x << " " << rays[i].direction.y
            << " " << rays[i].direction.z;
}

TEST(Watertight, SphereDoesNotLeak) {
    Random random{21};
    const Soup soup = sphere(60, 120, {0, 0, 0}, 1);
    expect_no_leak(soup, rays_from_inside(soup, random, 150000, {0, 0, 0}, 0.5f));
}

TEST(Watertight, SphereFarFromTheOriginDoesNotLeak) {
    Random random{22};
    const vec3 centre(1234.567f, -987.6f, 4321.1f);
    const Soup soup = sphere(40, 80, centre, 1);
    expect_no_leak(soup, rays_from_inside(soup, random, 60000, centre, 0.5f));
}

TEST(Watertight, CubeDoesNotLeak) {
    Random random{23};
    const Soup soup = cube(16, {0, 0, 0}, 1);
    expect_no_leak(soup, rays_from_inside(soup, random, 150000, {0, 0, 0}, 0.9f));
}

// Along the axes and diagonals from grid points: zero direction components, origins on box planes,
// rays through vertices and along the planes between boxes.
TEST(Watertight, AxisAlignedRaysOnTheGridDoNotLeak) {
    for (const vec3 centre : {vec3(0, 0, 0), vec3(0.1f, -3.7f, 100.3f)}) {
        const Soup soup = cube(16, centre, 1);
        std::vector<Ray> rays;
        for (int x = 1; x < 16; ++x)
            for (int y = 1; y < 16; ++y)
                for (int z = 1; z < 16; ++z) {
                    const vec3 origin = centre + (2.0f * vec3(x, y, z) / 16.0f - 1.0f);
                    for (int d = 0; d < 27; ++d) {
                        vec3 direction(d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
                        if (direction == vec3(0)) continue;
                        if (d % 2 == 0)  // also test negative zeros
                            for (std::size_t a = 0; a < 3; ++a)
                                if (direction[a] == 0) direction[a] = -0.0f;
                        rays.push_back({origin, direction, kInfinity});
                    }
                }
        expect_no_leak(soup, rays);
    }
}

// Rays that run in the plane of a cube's face, along the edges of other faces.
TEST(Watertight, RaysAlongTheGridLinesOfAFaceAreHandled) {
    const Soup soup = cube(4, {0, 0, 0}, 1);
    std::vector<Ray> rays;
    for (int i = 0; i <= 4; ++i) {
        const float x = 0.5f * float(i) - 1;
        rays.push_back({{x, 1, -3}, {0, 0, 1}, kInfinity});
        rays.push_back({{x, -1, -3}, {-0.0f, 0, 1}, kInfinity});
        rays.push_back({{-1, x, 3}, {0, -0.0f, -1}, kInfinity});
    }
    // The sides at z = -1 and z = 1 are closed squares: their boundary belongs to them.
    const Traced traced = trace_all(build_one(soup), rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_NE(traced.found[i], 0) << i;
        EXPECT_EQ(traced.hits[i].t, 2.0f) << i;
    }
}

// Rays that leave long narrow triangles, with origins offset from the surface as in shading.
TEST(Watertight, ANarrowTriangleIsNotHitByRaysThatLeaveIt) {
    Soup soup;
    for (int i = 0; i < 100; ++i) {
        const float near = 0.3f * float(i) - 15;
        soup.add({-16, 0, near}, {16, 0, near}, {16, 0, near + 0.3f});
        soup.add({-16, 0, near}, {16, 0, near + 0.3f}, {-16, 0, near + 0.3f});
    }
    soup.add({-40, -40, -40}, {40, -40, -40}, {0, -40, 40});  // padding scales with the scene size
    const Bvh bvh = build_one(soup);
    Random random{25};
    std::vector<Ray> rays;
    for (int i = 0; i < 50000; ++i) {
        vec3 direction = random.direction();
        direction.y = std::abs(direction.y);
        rays.push_back(
            {{random.between(-15, 15), 0x1p-16f, random.between(-14, 14)}, direction, kInfinity});
    }
    const Traced traced = trace_all(bvh, rays);
    EXPECT_EQ(std::count(traced.found.begin(), traced.found.end(), 1), 0);
}

TEST(Watertight, ExtremeScalesDoNotLeak) {
    for (const float scale : {1e-20f, 1e-10f, 1e8f, 1e16f}) {
        Random random{24};
        const Soup soup = sphere(20, 40, {0, 0, 0}, scale);
        std::vector<Ray> rays = rays_from_inside(soup, random, 20000, {0, 0, 0}, 0.5f * scale);
        for (Ray& ray : rays)
            ray.direction /= scale;
        SCOPED_TRACE(scale);
        expect_no_leak(soup, rays);
    }
}

}  // namespace
}  // namespace hm::bvh_test
