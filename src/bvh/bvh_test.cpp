#include "bvh/bvh.h"

#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <set>

#include "bvh/test_scene.h"

namespace hm::bvh_test {
namespace {

// Walks the subtree at `ref`: checks that boxes lie within their parents' boxes and that leaves are
// valid, and records every triangle seen. Returns the number of node levels.
struct Checker {
    const Bvh& bvh;
    std::multiset<std::array<std::uint32_t, 3>> seen;
    std::uint32_t instances_seen = 0;

    std::uint32_t check(std::uint32_t ref, const BvhBounds& outer) {
        const std::uint32_t index = ref & ~kBvhKindMask;
        if ((ref & kBvhKindMask) == kBvhInstance) {
            ++instances_seen;
            return 0;
        }
        if ((ref & kBvhKindMask) == kBvhPacket) {
            check_packet(index, outer);
            return 0;
        }
        std::uint32_t depth = 0;
        const BvhNode& node = bvh.nodes[index];
        for (std::size_t i = 0; i < kBvhWidth; ++i) {
            BvhBounds inner;
            for (int a = 0; a < 3; ++a) {
                inner.lo[a] = node.bounds[2 * a][i];
                inner.hi[a] = node.bounds[2 * a + 1][i];
            }
            if (node.child[i] == kBvhEmpty) {
                EXPECT_EQ(inner.lo[0], kInfinity);
                continue;
            }
            for (int a = 0; a < 3; ++a) {
                EXPECT_GE(inner.lo[a], outer.lo[a]);
                EXPECT_LE(inner.hi[a], outer.hi[a]);
            }
            depth = std::max(depth, check(node.child[i], inner));
        }
        return depth + 1;
    }

    void check_packet(std::uint32_t index, const BvhBounds& outer) {
        const BvhPacket& packet = bvh.packets[index];
        EXPECT_NE(packet.used, 0u);
        EXPECT_LT(packet.used, 256u);
        for (std::uint32_t l = 0; l < kBvhWidth; ++l) {
            if ((packet.used >> l & 1) == 0) continue;
            const BvhTriangleId id = bvh.ids[kBvhWidth * index + l];
            seen.insert({id.instance, id.geometry, id.primitive});
            for (int v = 0; v < 3; ++v)
                for (int a = 0; a < 3; ++a) {
                    EXPECT_GE(packet.position[v][a][l], outer.lo[a]);
                    EXPECT_LE(packet.position[v][a][l], outer.hi[a]);
                }
        }
    }
};

void expect_sound(const Bvh& bvh) {
    Checker checker{bvh, {}, 0};
    const std::uint32_t depth = checker.check(bvh.root, bvh.bounds);
    EXPECT_LE(depth, kBvhMaxDepth);
    if (bvh.instances.empty()) {
        EXPECT_EQ(checker.seen.size(), bvh.stats.triangles);
    }
    for (auto it = checker.seen.begin(); it != checker.seen.end(); ++it)
        EXPECT_EQ(checker.seen.count(*it), 1u);
    EXPECT_EQ(checker.instances_seen, bvh.instances.size());
}

bool same_nodes(const std::vector<BvhNode>& a, const std::vector<BvhNode>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return std::memcmp(x.bounds, y.bounds, sizeof x.bounds) == 0 &&
               std::memcmp(x.child, y.child, sizeof x.child) == 0;
    });
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(Bvh, EmptyScenesHitNothing) {
    const std::vector<Ray> rays{{{0, 0, 0}, {0, 0, 1}, kInfinity}};
    const std::vector<BvhInstance> instances{{0, mat4x3(1), mat4x3(1)}};
    Soup flat;
    flat.add({0, 0, 1}, {1, 1, 1}, {2, 2, 1});
    for (const Bvh& bvh :
         {build_bvh({}, {}), build_one(Soup{}), build_one(flat),
          build_bvh(std::vector<BvhMesh>(1), instances), build_bvh(std::vector<BvhMesh>(1), {})}) {
        EXPECT_EQ(bvh.root, kBvhEmpty);
        EXPECT_EQ(bvh.stats.triangles, 0u);
        EXPECT_EQ(trace_all(bvh, rays).found[0], 0);
    }
}

TEST(Bvh, SingleTriangle) {
    Soup soup;
    soup.add({-1, -1, 2}, {1, -1, 2}, {-1, 1, 2});
    const Bvh bvh = build_one(soup);
    EXPECT_EQ(bvh.stats.triangles, 1u);
    EXPECT_EQ(bvh.stats.nodes, 0u);
    const Traced traced = trace_all(bvh, {{{-0.5f, 0, 0}, {0, 0, 0.5f}, kInfinity}});
    ASSERT_EQ(traced.found[0], 1);
    EXPECT_EQ(traced.hits[0].t, 4);
    EXPECT_EQ(traced.hits[0].u, 0.25f);
    EXPECT_EQ(traced.hits[0].v, 0.5f);
}

TEST(Bvh, DegenerateTrianglesAreLeftOutAndCounted) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Soup soup;
    soup.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
    soup.add({0, 0, 1}, {0, 0, 1}, {1, 0, 1});  // two corners coincide
    soup.add({0, 0, 1}, {1, 2, 1}, {2, 4, 1});  // on a line
    soup.add({nan, 0, 1}, {1, 0, 1}, {0, 1, 1});
    soup.add({0, 0, 1}, {1, kInfinity, 1}, {0, 1, 1});
    soup.add({0, 0, 0}, {1e-30f, 0, 0}, {0, 1e-30f, 0});  // tiny, but a triangle
    const Bvh bvh = build_one(soup);
    EXPECT_EQ(bvh.stats.triangles, 2u);
    EXPECT_EQ(bvh.stats.degenerate_triangles, 4u);
    expect_sound(bvh);
    EXPECT_EQ(trace_all(bvh, {{{0, 0, 1}, {0, 0, 1}, kInfinity}}).hits[0].primitive, 0u);
}

TEST(Bvh, TreesAreSound) {
    Random random{31};
    for (const int count : {2, 3, 8, 9, 13, 100, 5000, 70000}) {
        const Soup soup = random_soup(random, count, 1, 0.05f);
        expect_sound(build_one(soup));
    }
}

TEST(Bvh, TreeDoesNotDependOnThreads) {
    Random random{32};
    const Soup soup = random_soup(random, 150000, 1, 0.01f);
    tbb::task_arena one(1);
    tbb::task_arena two(2);
    const Bvh a = one.execute([&] { return build_one(soup); });
    const Bvh b = two.execute([&] { return build_one(soup); });
    EXPECT_TRUE(same_nodes(a.nodes, b.nodes));
    EXPECT_TRUE(same_bytes(a.packets, b.packets));
    EXPECT_TRUE(same_bytes(a.ids, b.ids));
}

TEST(Bvh, IdenticalCentroidsBuildAndTrace) {
    Soup soup;
    for (int i = 0; i < 200000; ++i) {
        // Boxes around the same centre with different sizes.
        const float s = 0.5f + float(i % 1000) * 0x1p-10f;
        soup.add({-s, -s, 1}, {s, -s, 1}, {-s, s, 1});
    }
    const Bvh bvh = build_one(soup);
    expect_sound(bvh);
    const Traced traced = trace_all(bvh, {{{-0.2f, -0.2f, 0}, {0, 0, 1}, kInfinity}});
    EXPECT_EQ(traced.hits[0].primitive, 0u);
}

// Triangle sizes form a geometric sequence (factor 10): SAH splits them off one by one.
TEST(Bvh, GeometricSequencesStayWithinTheDepth) {
    Soup soup;
    for (int copy = 0; copy < 40; ++copy)
        for (int i = 0; i < 36; ++i) {
            const float x = std::pow(10.0f, float(i - 18)) * (1 + float(copy) * 0.01f);
            soup.add({x, 0, 0}, {2 * x, 0, 0}, {x, x, 0.1f * x});
        }
    expect_sound(build_one(soup));
}

TEST(Bvh, LongThinScenesAndDuplicates) {
    Random random{34};
    Soup soup;
    for (int i = 0; i < 3000; ++i) {
        const vec3 p(random.between(0, 1e6f), random.between(0, 1), 5);
        for (int copy = 0; copy < 12; ++copy)
            soup.add(p, p + vec3(1, 0, 0), p + vec3(0, 1, 0));
    }
    expect_sound(build_one(soup));
}

}  // namespace
}  // namespace hm::bvh_test
