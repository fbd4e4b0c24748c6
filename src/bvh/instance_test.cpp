// Scenes of several meshes and instances: which instances are merged, and that merged and unmerged
// ones give correct hits.
#include <algorithm>

#include "bvh/test_scene.h"

namespace hm::bvh_test {
namespace {

struct Placed {
    mat4x3 object_to_world, world_to_object;
};

Placed place(const glm::dmat3& linear, const glm::dvec3& shift) {
    const glm::dmat3 inverse = glm::inverse(linear);
    const glm::dvec3 back = -(inverse * shift);
    Placed placed;
    for (std::size_t c = 0; c < 3; ++c) {
        placed.object_to_world[c] = vec3(linear[c]);
        placed.world_to_object[c] = vec3(inverse[c]);
    }
    placed.object_to_world[3] = vec3(shift);
    placed.world_to_object[3] = vec3(back);
    return placed;
}

// A random rotation with non-uniform scale; every third one is mirrored.
Placed random_place(Random& random, int index, float half) {
    glm::dmat3 m;
    const glm::dvec3 x(random.direction());
    const glm::dvec3 y(glm::normalize(glm::cross(x, glm::dvec3(random.direction()))));
    m[0] = x * double(random.between(0.3f, 2));
    m[1] = y * double(random.between(0.3f, 2));
    m[2] = glm::cross(x, y) * double(random.between(0.3f, 2)) * (index % 3 == 0 ? -1.0 : 1.0);
    return place(m, glm::dvec3(random.in_cube(half)));
}

struct TestScene {
    std::vector<Soup> soups;
    std::vector<BvhMesh> meshes;
    std::vector<BvhInstance> instances;
};

std::vector<Ray> random_rays(Random& random, int count, float half) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i) {
        const vec3 origin = random.in_cube(half);
        const vec3 direction = random.direction();
        rays.push_back({origin, direction, kInfinity});
    }
    return rays;
}

// Compares with a brute-force search over all triangles of all instances, in double precision and
// world space.
void expect_double(const TestScene& scene, const Bvh& bvh, const std::vector<Ray>& rays) {
    const Traced traced = trace_all(bvh, rays);
    constexpr double kMargin = 1e-3;
    std::size_t compared = 0;
    std::size_t found = 0;
    for (std::size_t r = 0; r < rays.size(); ++r) {
        double closest = std::numeric_limits<double>::infinity();
        double second = closest;
        Hit expected{};
        bool doubtful = false;
        for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
            const BvhInstance& instance = scene.instances[i];
            const glm::dmat4x3 m(instance.object_to_world);
            const auto& geometries = scene.meshes[instance.mesh].geometries;
            for (std::uint32_t g = 0; g < geometries.size(); ++g)
                for (std::uint32_t k = 0; k < geometries[g].triangles.size(); ++k) {
                    glm::dvec3 p[3];
                    for (std::size_t v = 0; v < 3; ++v) {
                        const std::uint32_t index = geometries[g].triangles[k][v];
                        p[v] =
                            m * glm::dvec4(glm::dvec3(geometries[g].vertices[index].position), 1);
                    }
                    const auto hit = intersect_double(p[0], p[1], p[2], glm::dvec3(rays[r].origin),
                                                      glm::dvec3(rays[r].direction));
                    if (!hit || hit->t < -1e-3 || hit->margin < -kMargin) continue;
                    if (hit->margin < kMargin || hit->t < 1e-3) doubtful = true;
                    if (hit->t < closest) {
                        second = closest;
                        closest = hit->t;
                        expected = {float(hit->t), float(hit->u), float(hit->v), i, g, k};
                    } else {
                        second = std::min(second, hit->t);
                    }
                }
        }
        if (doubtful || second - closest < 1e-3) continue;
        ++compared;
        ASSERT_EQ(closest < double(kInfinity), traced.found[r] != 0) << "ray " << r;
        if (!traced.found[r]) continue;
        ++found;
        const Hit& hit = traced.hits[r];
        ASSERT_EQ(hit.instance, expected.instance) << "ray " << r;
        ASSERT_EQ(hit.geometry, expected.geometry) << "ray " << r;
        ASSERT_EQ(hit.primitive, expected.primitive) << "ray " << r;
        ASSERT_NEAR(hit.t, expected.t, 1e-3f) << "ray " << r;
        ASSERT_NEAR(hit.u, expected.u, 2e-2f) << "ray " << r;
        ASSERT_NEAR(hit.v, expected.v, 2e-2f) << "ray " << r;
    }
    EXPECT_GT(compared, rays.size() * 3 / 4);
    EXPECT_GT(found, rays.size() / 10);
}

TestScene mixed_scene(Random& random, int instances, int triangles) {
    TestScene scene;
    for (int s = 0; s < 6; ++s)
        scene.soups.push_back(random_soup(random, triangles, 0.5f, 0.8f));
    scene.meshes.push_back({{scene.soups[0].geometry(), scene.soups[1].geometry()}});
    scene.meshes.push_back({{scene.soups[2].geometry()}});
    scene.meshes.push_back({{scene.soups[3].geometry()}});                             // used once
    scene.meshes.push_back({{scene.soups[4].geometry(), scene.soups[5].geometry()}});  // once
    for (int i = 0; i < instances; ++i) {
        const Placed p = random_place(random, i, 4);
        const auto mesh = std::uint32_t(i == 3 ? 2 : i == 5 ? 3 : i % 2);
        scene.instances.push_back({mesh, p.object_to_world, p.world_to_object});
    }
    return scene;
}

TEST(Instances, MirroredAndStretchedInstancesAgreeWithDouble) {
    Random random{41};
    const TestScene scene = mixed_scene(random, 40, 80);
    const Bvh bvh = build_bvh(scene.meshes, scene.instances);
    EXPECT_EQ(bvh.stats.merged_instances, 2u);
    EXPECT_EQ(bvh.instances.size(), 38u);
    EXPECT_EQ(bvh.stats.triangles, 6u * 80);
    expect_double(scene, bvh, random_rays(random, 2000, 4));
}

TEST(Instances, OnlyMergedMeshesNeedNoTopLevel) {
    Random random{42};
    TestScene scene = mixed_scene(random, 40, 80);
    scene.instances = {scene.instances[3], scene.instances[5], scene.instances[0],
                       scene.instances[1]};
    const Bvh bvh = build_bvh(scene.meshes, scene.instances);
    EXPECT_EQ(bvh.stats.merged_instances, 4u);
    EXPECT_TRUE(bvh.instances.empty());
    expect_double(scene, bvh, random_rays(random, 2000, 4));
}

TEST(Instances, FlattenedInstancesAreMerged) {
    Random random{43};
    TestScene scene = mixed_scene(random, 6, 80);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    BvhInstance flat = scene.instances[0];
    flat.object_to_world[2] = vec3(0);
    flat.world_to_object = mat4x3(vec3(nan), vec3(nan), vec3(nan), vec3(nan));
    scene.instances.push_back(flat);
    scene.instances.push_back(scene.instances[0]);
    scene.instances.back().object_to_world[3] += vec3(1, 0, 0);
    const Placed moved = place(glm::dmat3(glm::dmat4x3(scene.instances.back().object_to_world)),
                               glm::dvec3(scene.instances.back().object_to_world[3]));
    scene.instances.back().world_to_object = moved.world_to_object;
    const Bvh bvh = build_bvh(scene.meshes, scene.instances);
    EXPECT_GE(bvh.stats.merged_instances, 1u);
    expect_double(scene, bvh, random_rays(random, 2000, 4));
}

TEST(Instances, EqualInstancesGiveTheLowestId) {
    Random random{44};
    TestScene scene = mixed_scene(random, 1, 600);
    for (int i = 0; i < 20; ++i)
        scene.instances.push_back(scene.instances[0]);
    const Bvh bvh = build_bvh(scene.meshes, scene.instances);
    const Traced traced = trace_all(bvh, random_rays(random, 2000, 2));
    int found = 0;
    for (std::size_t i = 0; i < traced.found.size(); ++i) {
        if (!traced.found[i]) continue;
        ++found;
        EXPECT_EQ(traced.hits[i].instance, 0u);
    }
    EXPECT_GT(found, 100);
}

TEST(Instances, ManyInstancesOfOneMesh) {
    Random random{45};
    TestScene scene;
    scene.soups.push_back(random_soup(random, 300, 0.5f, 0.3f));
    scene.meshes.push_back({{scene.soups[0].geometry()}});
    for (int i = 0; i < 300; ++i) {
        const Placed p = random_place(random, i, 10);
        scene.instances.push_back({0, p.object_to_world, p.world_to_object});
    }
    expect_double(scene, build_bvh(scene.meshes, scene.instances), random_rays(random, 400, 10));
}

}  // namespace
}  // namespace hm::bvh_test
