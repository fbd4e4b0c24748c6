// Which acceleration structures a scene gets, as plain data.
#include "gpu/structures.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "support/scenes.h"

namespace hm {
namespace {

using test::SceneBuilder;

FlatScene flatten_quietly(const SceneBuilder& builder) {
    return test::flatten_quietly(builder.scene);
}

glm::mat4 moved(float x) {
    return glm::translate(glm::mat4(1), vec3(x, 0, 0));
}

TEST(Structures, InstancesShareTheirMesh) {
    SceneBuilder b;
    const int grey = b.material(test::lambertian(vec3(0.5f)));
    const int cube = test::add_cube(b, false, grey);
    b.sphere(8, grey);  // placed nowhere
    b.place(cube, moved(0));
    b.place(cube, moved(3));
    const FlatScene flat = flatten_quietly(b);
    const StructurePlan plan = plan_structures(flat);
    ASSERT_EQ(plan.blas.size(), 1u);
    EXPECT_EQ(plan.blas[0].mesh, std::uint32_t(cube));
    EXPECT_EQ(plan.blas[0].baked_instance, kNone);
    ASSERT_EQ(plan.placed.size(), 2u);
    EXPECT_EQ(plan.placed[1].instance, 1u);
    EXPECT_EQ(plan.placed[1].blas, 0u);
}

TEST(Structures, AnOpaqueMeshAtTheSamePlaceIsThereOnce) {
    SceneBuilder b;
    Material glass = test::lambertian(vec3(0.5f));
    glass.alpha_mode = kAlphaBlend;
    const int opaque = test::add_cube(b, false, b.material(test::lambertian(vec3(0.5f))));
    const int blended = test::add_cube(b, false, b.material(glass));
    for (const int mesh : {opaque, blended, opaque, blended, opaque})
        b.place(mesh, moved(1));
    const FlatScene flat = flatten_quietly(b);
    const StructurePlan plan = plan_structures(flat);
    EXPECT_EQ(plan.duplicates, 2u);
    ASSERT_EQ(plan.placed.size(), 3u);
    EXPECT_EQ(plan.placed[0].instance, 0u);  // the lowest stays
    EXPECT_EQ(plan.placed[1].instance, 1u);
    EXPECT_EQ(plan.placed[2].instance, 3u);  // both layers of glass dim
}

TEST(Structures, TinyTransformsAreBaked) {
    SceneBuilder b;
    const int cube = test::add_cube(b, false, b.material(test::lambertian(vec3(0.5f))));
    b.place(cube, glm::scale(glm::mat4(1), vec3(1e-12f)));
    b.place(cube, moved(1));
    const FlatScene flat = flatten_quietly(b);
    const StructurePlan plan = plan_structures(flat);
    ASSERT_EQ(plan.blas.size(), 2u);
    EXPECT_EQ(plan.blas[0].baked_instance, 0u);
    EXPECT_EQ(plan.blas[1].baked_instance, kNone);
}

TEST(Structures, AMeshWithoutTrianglesIsNotPlaced) {
    SceneBuilder b;
    b.place(b.mesh({Primitive{}}), moved(0));
    const FlatScene flat = flatten_quietly(b);
    const StructurePlan plan = plan_structures(flat);
    EXPECT_TRUE(plan.blas.empty());
    EXPECT_TRUE(plan.placed.empty());
}

}  // namespace
}  // namespace hm
