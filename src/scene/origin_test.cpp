#include "scene/origin.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/pose.h"
#include "support/scenes.h"

namespace hm {
namespace {

glm::dvec3 chosen(Scene scene) {
    set_origin(scene);
    return scene.origin;
}

// A square of half extent `size` whose node is moved to `position`.
Scene square_at(const glm::dvec3& position, float size = 1) {
    test::SceneBuilder b;
    const int mesh = b.quad(vec3(-size, 0, size), vec3(2 * size, 0, 0), vec3(0, 0, -2 * size),
                            b.material(test::lambertian(vec3(0.5f))));
    b.place(mesh);
    b.scene.nodes[0].local = glm::translate(glm::dmat4(1), position);
    return b.scene;
}

TEST(Origin, AScenesOwnWhereFloatsResolveIt) {
    EXPECT_EQ(chosen(Scene()), glm::dvec3(0));
    EXPECT_EQ(chosen(square_at({0, 0, 0})), glm::dvec3(0));
    // The radius of the square is sqrt(2): 16 of them are 22.6.
    EXPECT_EQ(chosen(square_at({22.5, -22.5, 1})), glm::dvec3(0));
    EXPECT_NE(chosen(square_at({22.7, 0, 0})), glm::dvec3(0));
    // A point has no radius to compare with.
    EXPECT_EQ(chosen(square_at({100, 0, 0}, 0)), glm::dvec3(0));
}

// Multiples of the power of two below the radius, at any scale.
TEST(Origin, TheMiddleOfADistantSceneIsRounded) {
    EXPECT_EQ(chosen(square_at({6000000.3, 0.25, -4000000.75})), glm::dvec3(6000000, 0, -4000001));
    EXPECT_EQ(chosen(square_at({1e-3, 0, 0}, 0x1p-20f)), glm::dvec3(1049 * 0x1p-20, 0, 0));
    EXPECT_EQ(chosen(square_at({0, 1e12, 0}, 0x1p20f)), glm::dvec3(0, 953674 * 0x1p20, 0));
}

// Sums in double precision: a parent at 6e6, turned, with a child that brings the mesh back by what
// a float cannot hold.
TEST(Origin, NestedNodesKeepTheirPrecision) {
    Scene scene = square_at({0, 0, 0});
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(0, 1, 0));
    const glm::dvec3 far(6378137.0625, 12.5, -2500000.375);
    Node parent;
    parent.local = glm::translate(glm::dmat4(1), far) * turn;
    scene.nodes[0].local = glm::translate(
        glm::dmat4(1), glm::dvec3(glm::inverse(turn) * glm::dvec4(1.0 / 1024 - far, 1)));
    scene.nodes[0].parent = 0;
    scene.nodes.insert(scene.nodes.begin(), parent);
    set_origin(scene);
    EXPECT_TRUE(scene.double_precision);
    EXPECT_EQ(scene.origin, glm::dvec3(0));
    const vec3 at(world_transforms(scene)[1][3]);
    EXPECT_NEAR(at.x, 1.0f / 1024, 1e-8f);
    EXPECT_NEAR(at.y, 1.0f / 1024, 1e-8f);
    EXPECT_NEAR(at.z, 1.0f / 1024, 1e-8f);
}

TEST(Origin, NearScenesAreRoundedToFloats) {
    const Transform exact{
        .translation = {0.1, 0.2, 0.3}, .rotation = {0.1, 0.7, 0.1, 0.3}, .scale = {0.1, 0.2, 0.7}};
    const Transform rounded = round_to_floats(exact);
    for (glm::length_t i = 0; i < 3; ++i) {
        EXPECT_EQ(rounded.translation[i], double(float(exact.translation[i])));
        EXPECT_EQ(rounded.scale[i], double(float(exact.scale[i])));
    }
    for (glm::length_t i = 0; i < 4; ++i)
        EXPECT_EQ(rounded.rotation[i], double(float(exact.rotation[i])));
    Scene scene = square_at({0, 0, 0});
    scene.nodes[0].rest = exact;
    set_origin(scene);
    EXPECT_EQ(scene.nodes[0].local, glm::dmat4(glm::mat4(to_matrix(rounded))));
}

// Meshes, lights and cameras.
TEST(Origin, WorldTransformsAreRelativeToIt) {
    Scene scene = square_at({6000000.25, 0, 0});
    scene.lights.push_back({});
    Node lamp;
    lamp.light = 0;
    lamp.local = glm::translate(glm::dmat4(1), glm::dvec3(6000001.125, 2, 0));
    scene.nodes.push_back(lamp);
    set_origin(scene);
    Diagnostics diagnostics;
    const FlatScene flat = flatten(scene, {}, {}, diagnostics);
    EXPECT_EQ(flat.bounds.low, vec3(-0.75f, 0, -1));
    EXPECT_EQ(flat.bounds.high, vec3(1.25f, 0, 1));
    EXPECT_EQ(flat.lights[0].position, vec3(1.125f, 2, 0));
}

// The position of a skinned mesh depends on its joints, not on its node; posed vertices are
// relative to the origin.
TEST(Origin, OfASkinnedMesh) {
    Scene scene = square_at({0, 0, 0});
    Primitive& p = scene.meshes[0].primitives[0];
    auto d = std::make_shared<Deformation>();
    d->rest = p.vertices;
    d->influences = 1;
    d->joints.assign(p.vertices.size(), 0);
    d->weights.assign(p.vertices.size(), 1);
    p.deformation = d;
    scene.skins.push_back({"", {1}, {glm::mat4(1)}});
    scene.nodes[0].skin = 0;
    Node joint;
    joint.local = glm::translate(glm::dmat4(1), glm::dvec3(0, 6000000.25, 0));
    scene.nodes.push_back(joint);
    set_origin(scene);
    EXPECT_EQ(scene.origin, glm::dvec3(0, 6000000, 0));
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    for (const Vertex& v : p.vertices)
        EXPECT_EQ(v.position.y, 0.25f);
}

// Interpolation between two positions that floats hold gives one that they do not.
TEST(Origin, AnimationKeepsPrecision) {
    Scene scene = square_at({0, 0, 0});
    scene.nodes[0].rest = Transform{.translation = {8000000, 0, 0}};
    scene.nodes[0].local = to_matrix(*scene.nodes[0].rest);
    set_origin(scene);
    scene.animations.push_back({"",
                                {{Interpolation::linear, {0, 1}, {8000000, 0, 0, 8000001, 0, 0}}},
                                {{0, 0, AnimatedProperty::translation}},
                                {}});
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 0.125}));
    EXPECT_EQ(world_transforms(scene)[0][3].x, 0.125);
}

}  // namespace
}  // namespace hm
