#include "bvh/traverse.h"

#include <algorithm>
#include <tuple>

#include "bvh/test_scene.h"

namespace hm::bvh_test {
namespace {

std::vector<Ray> random_rays(Random& random, int count, float half) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const vec3 origin = random.in_cube(half);
        const vec3 direction = random.direction() * random.between(0.1f, 10);
        rays.push_back({origin, direction, i % 4 == 0 ? random.between(0, half) : kInfinity});
    }
    return rays;
}

// Reference without a tree: each triangle alone in a packet. Results must be bit-identical.
std::optional<Hit> brute_force(const Soup& soup, const Bvh& bvh, const Ray& ray, bool only_even) {
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    const RaySpace space = make_ray_space(origin, direction, bvh.bounds);
    std::optional<Hit> best;
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
        if (only_even && i % 2 != 0) continue;
        BvhPacket packet{};
        for (int v = 0; v < 3; ++v)
            for (std::size_t a = 0; a < 3; ++a)
                packet.position[v][a][0] = soup.corner(i, v)[a];
        packet.used = 1;
        PacketHits hits;
        if (intersect_packet(packet, space.triangle, kInfinity, hits) == 0) continue;
        const float t = std::max(hits.t[0], triangle_entry(packet, 0, space.triangle));
        if (t < (best ? best->t : ray.t_max)) best = Hit{t, hits.u[0], hits.v[0], 0, 0, i};
    }
    return best;
}

void expect_brute_force(const Soup& soup, const Bvh& bvh, const std::vector<Ray>& rays,
                        bool only_even = false) {
    const Traced traced = trace_all(bvh, rays, only_even ? kAcceptEven : kAcceptAll);
    int found = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::optional<Hit> expected = brute_force(soup, bvh, rays[i], only_even);
        ASSERT_EQ(expected.has_value(), traced.found[i] != 0) << "ray " << i;
        if (!expected) continue;
        ++found;
        ASSERT_EQ(0, std::memcmp(&*expected, &traced.hits[i], sizeof(Hit)))
            << "ray " << i << ": " << expected->primitive << " at " << expected->t << ", got "
            << traced.hits[i].primitive << " at " << traced.hits[i].t;
    }
    EXPECT_GT(found, int(rays.size() / 60));  // enough rays must hit for the test to be meaningful
}

TEST(Traverse, SoupsAgreeWithBruteForceBitByBit) {
    Random random{1};
    for (const int count : {1, 2, 7, 8, 9, 40, 700}) {
        const Soup soup = random_soup(random, count, 1, count < 40 ? 2.0f : 0.4f);
        expect_brute_force(soup, build_one(soup), random_rays(random, 3000, 1.5f));
    }
}

// Needles so thin that rounding errors shift t along them: the box test must still not cull hits.
TEST(Traverse, NeedlesAgreeWithBruteForceBitByBit) {
    Random random{2};
    Soup soup;
    for (int i = 0; i < 500; ++i) {
        const vec3 p = random.in_cube(1);
        const vec3 along = random.direction();
        const float width = i % 2 == 0 ? 1e-5f : 2e-7f;
        soup.add(p, p + along, p + 0.5f * along + width * random.direction());
    }
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        const std::size_t t = random.bits() % soup.triangles.size();
        const vec3 target = mix(soup.corner(t, 0), soup.corner(t, 1), random.unit());
        const vec3 origin =
            i % 2 == 0 ? mix(soup.corner(t, 0), soup.corner(t, 1), -1.0f) : random.in_cube(2);
        rays.push_back({origin, target - origin, kInfinity});
    }
    expect_brute_force(soup, build_one(soup), rays);
}

TEST(Traverse, SoupsAgreeWithDouble) {
    Random random{3};
    const Soup soup = random_soup(random, 300, 1, 0.5f);
    const std::vector<Ray> rays = random_rays(random, 5000, 1.5f);
    const Traced traced = trace_all(build_one(soup), rays);
    // Coordinates are below 4 and triangles about 0.3 wide. The error of a sheared coordinate is
    // about 2^-22; that of a barycentric weight is this divided by the triangle's projected width,
    // which is at least 1e-2 for nearly all.
    constexpr double kMargin = 1e-4;
    int compared = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        double closest = double(rays[i].t_max);
        double best_margin = 1;
        bool doubtful = false;
        for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
            const auto hit =
                intersect_double(glm::dvec3(soup.corner(k, 0)), glm::dvec3(soup.corner(k, 1)),
                                 glm::dvec3(soup.corner(k, 2)), glm::dvec3(rays[i].origin),
                                 glm::dvec3(rays[i].direction));
            if (!hit || hit->margin < -kMargin) continue;
            if (std::abs(hit->margin) < kMargin || std::abs(hit->t) < 1e-4) doubtful = true;
            if (hit->t > 0 && hit->t < closest) {
                closest = hit->t;
                best_margin = hit->margin;
            }
        }
        if (doubtful || best_margin < kMargin) continue;
        ++compared;
        const bool expected = closest < double(rays[i].t_max);
        ASSERT_EQ(expected, traced.found[i] != 0) << "ray " << i;
        if (expected) {
            ASSERT_NEAR(double(traced.hits[i].t), closest, 1e-3 * closest) << "ray " << i;
        }
    }
    EXPECT_GT(compared, 4500);
}

TEST(Traverse, BarycentricsGiveTheHitPoint) {
    Random random{4};
    const Soup soup = random_soup(random, 200, 1, 1);
    const std::vector<Ray> rays = random_rays(random, 2000, 1.5f);
    const Traced traced = trace_all(build_one(soup), rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!traced.found[i]) continue;
        const Hit& h = traced.hits[i];
        const glm::dvec3 a(soup.corner(h.primitive, 0));
        const glm::dvec3 b(soup.corner(h.primitive, 1));
        const glm::dvec3 c(soup.corner(h.primitive, 2));
        const double u = double(h.u);
        const double v = double(h.v);
        const glm::dvec3 expected = (1 - u - v) * a + u * b + v * c;
        const glm::dvec3 p =
            glm::dvec3(rays[i].origin) + double(h.t) * glm::dvec3(rays[i].direction);
        // Perpendicular to the ray the error is the rounding of the sheared coordinates (below 8);
        // along it the same, as t and the weights are computed from the same values.
        ASSERT_LT(glm::length(p - expected), 1e-5) << "ray " << i;
    }
}

TEST(Traverse, CoincidentTrianglesGiveTheLowestId) {
    Random random{5};
    const Soup once = random_soup(random, 50, 1, 1);
    for (int order = 0; order < 2; ++order) {
        // Each triangle three times, in two different orders.
        std::vector<Soup> soups(2);
        std::vector<std::uint32_t> of;
        for (int copy = 0; copy < 2; ++copy)
            for (std::size_t i = 0; i < 50; ++i) {
                const std::size_t k = order == 0 ? i : 49 - i;
                of.push_back(std::uint32_t(k));
                soups[0].add(once.corner(k, 0), once.corner(k, 1), once.corner(k, 2));
            }
        soups[1] = once;
        const std::vector<BvhMesh> meshes{{{soups[0].geometry(), soups[1].geometry()}}};
        const std::vector<BvhInstance> instances{{0, mat4x3(1), mat4x3(1)}};
        const Traced traced = trace_all(build_bvh(meshes, instances), random_rays(random, 5000, 2));
        for (std::size_t i = 0; i < traced.found.size(); ++i) {
            if (!traced.found[i]) continue;
            ASSERT_EQ(traced.hits[i].geometry, 0u);
            ASSERT_LT(traced.hits[i].primitive, 50u);
        }
    }
}

// Overlapping coplanar triangles: equal distances in different boxes.
TEST(Traverse, OverlappingFlatSheetsGiveTheLowestId) {
    Soup soup;
    Random random{6};
    for (int i = 0; i < 400; ++i) {
        const float x = random.between(-1, 1);
        const float y = random.between(-1, 1);
        const float size = random.between(0.1f, 1);
        soup.add({x, y, 0.7f}, {x + size, y, 0.7f}, {x, y + size, 0.7f});
    }
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
        const vec3 origin(random.between(-1, 1), random.between(-1, 1), -0.3f);
        rays.push_back({origin, {0, 0, i % 2 == 0 ? 1.0f : 0.37f}, kInfinity});
    }
    expect_brute_force(soup, build_one(soup), rays);
}

TEST(Traverse, AcceptDecidesOnGeometryThatIsNotOpaque) {
    Random random{7};
    const Soup soup = random_soup(random, 300, 1, 0.6f);
    const std::vector<Ray> rays = random_rays(random, 3000, 1.5f);
    expect_brute_force(soup, build_one(soup, false), rays, true);
    EXPECT_GT(trace(trace_variants()[0], build_one(soup, false), rays).accept_calls, 1000u);
    EXPECT_EQ(trace(trace_variants()[0], build_one(soup, true), rays).accept_calls, 0u);
}

TEST(Traverse, AcceptIsAskedOncePerTriangle) {
    Random random{8};
    const Soup soup = random_soup(random, 500, 0.1f, 2);
    const Bvh bvh = build_one(soup, false);
    const BvhView view = bvh.view();
    for (const Ray& ray : random_rays(random, 500, 1)) {
        std::vector<std::uint32_t> asked;
        const auto refuse = [&](const Hit& hit) {
            asked.push_back(hit.primitive);
            return false;
        };
        Hit hit;
        EXPECT_FALSE(trace_closest(view, ray, hit, refuse));
        std::sort(asked.begin(), asked.end());
        EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end());
        const std::size_t all = asked.size();
        EXPECT_FALSE(trace_any(view, ray, refuse));
        EXPECT_EQ(asked.size(), 2 * all);  // nothing is accepted, so both see every candidate
    }
}

TEST(Traverse, DistancesAreStrictlyBetweenZeroAndTheLimit) {
    Soup soup;
    soup.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    const Bvh bvh = build_one(soup);
    const auto found = [&](float z, float t_max) {
        return trace_all(bvh, {{{0, 0, z}, {0, 0, 1}, t_max}}).found[0] != 0;
    };
    EXPECT_TRUE(found(0, kInfinity));
    EXPECT_FALSE(found(0, 2));
    EXPECT_TRUE(found(0, std::nextafter(2.0f, 3.0f)));
    EXPECT_FALSE(found(2, kInfinity));  // starts on the triangle
    EXPECT_FALSE(found(3, kInfinity));
    EXPECT_FALSE(found(0, 0));
    EXPECT_FALSE(found(0, -1));
    EXPECT_FALSE(found(0, std::numeric_limits<float>::quiet_NaN()));
}

TEST(Traverse, GiantAndTinyCoordinates) {
    for (const float scale : {1e-28f, 1e-15f, 1e-6f, 1e6f, 1e15f, 1e28f}) {
        Random random{9};
        const Soup soup = random_soup(random, 200, scale, 0.5f * scale);
        std::vector<Ray> rays = random_rays(random, 1000, 1.5f);
        for (Ray& ray : rays) {
            ray.origin *= scale;
            ray.t_max *= scale;
        }
        SCOPED_TRACE(scale);
        expect_brute_force(soup, build_one(soup), rays);
    }
}

TEST(Traverse, RaysThatAreNotNumbersHitNothing) {
    Random random{10};
    const Soup soup = random_soup(random, 100, 1, 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Traced traced = trace_all(build_one(soup), {{{nan, 0, 0}, {0, 0, 1}, kInfinity},
                                                      {{0, 0, 0}, {0, nan, 1}, kInfinity},
                                                      {{nan, nan, nan}, {nan, nan, nan}, 1},
                                                      {{0, 0, 0}, {0, 0, 0}, kInfinity}});
    for (const std::uint8_t found : traced.found)
        EXPECT_EQ(found, 0);
}

}  // namespace
}  // namespace hm::bvh_test
