// Posed scenes built in code: what moves, what does not, and that no earlier pose leaks through.
#include "scene/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "scene/flatten.h"

namespace hm {
namespace {

Vertex vertex(vec3 position, vec3 normal) {
    return {position, normal, vec4(0, 1, 0, 1), vec2(0)};
}

void expect_near(vec3 got, vec3 expected) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(double(got[i]), double(expected[i]), 1e-6) << i;
}

Transform moved(vec3 translation) {
    Transform t;
    t.translation = translation;
    return t;
}

int add_node(Scene& scene, int parent, const Transform& rest) {
    Node node;
    node.parent = parent;
    node.rest = rest;
    node.local = to_matrix(rest);
    scene.nodes.push_back(node);
    return int(scene.nodes.size()) - 1;
}

// A strip along the y axis. Vertices: at the lower joint, at the upper joint, one unit above it,
// and one between them weighted equally to both. Joint 1 is at height 1.
Primitive strip() {
    auto d = std::make_shared<Deformation>();
    for (const float y : {0.0f, 1.0f, 2.0f, 1.5f})
        d->rest.push_back(vertex({0, y, 0}, {1, 0, 0}));
    d->influences = 4;
    d->joints = {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    d->weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0};
    Primitive p;
    p.vertices = d->rest;
    p.triangles = {{0, 1, 2}, {0, 1, 3}};
    p.has_normals = p.has_tangents = true;
    p.deformation = d;
    return p;
}

// Node 0 has the skin and a transform of its own; the joints are nodes 1 and 2. The animation
// rotates the upper joint by 90 degrees about z, x to y, within one second.
Scene bent_scene() {
    Scene scene;
    scene.meshes.push_back({"strip", {strip()}, {}});
    Transform away = moved({100, 50, 0});
    away.scale = vec3(7);
    const int wearer = add_node(scene, kUnset, away);
    const int lower = add_node(scene, kUnset, moved({0, 0, 3}));
    const int upper = add_node(scene, lower, moved({0, 1, 0}));
    scene.nodes[std::size_t(wearer)].mesh = 0;
    scene.nodes[std::size_t(wearer)].skin = 0;
    Skin skin;
    skin.joints = {lower, upper};
    skin.inverse_bind = {glm::mat4(1), glm::translate(glm::mat4(1), vec3(0, -1, 0))};
    scene.skins.push_back(skin);
    Animation bend{"bend", {}, {}};
    const float s = std::sqrt(0.5f);
    bend.samplers.push_back({Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, s, s}});
    bend.channels.push_back({0, std::size_t(upper), AnimatedProperty::rotation});
    scene.animations.push_back(bend);
    return scene;
}

TEST(Skins, RestPoseFollowsTheJointsAlone) {
    Scene scene = bent_scene();
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    // The lower joint moves the whole strip to z = 3; node 0's own transform is ignored.
    const std::vector<Vertex>& v = scene.meshes[0].primitives[0].vertices;
    expect_near(v[0].position, {0, 0, 3});
    expect_near(v[2].position, {0, 2, 3});
    Diagnostics diagnostics;
    const FlatScene flat = flatten(scene, {}, {}, diagnostics);
    ASSERT_EQ(flat.instances.size(), 1u);
    EXPECT_EQ(flat.instances[0].object_to_world, mat4x3(1));
    EXPECT_EQ(flat.instances[0].flags, 0u);
    expect_near(flat.bounds.high, {0, 2, 3});
}

TEST(Skins, NinetyDegreesByHand) {
    Scene scene = bent_scene();
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 1}));
    const std::vector<Vertex>& v = scene.meshes[0].primitives[0].vertices;
    expect_near(v[0].position, {0, 0, 3});
    expect_near(v[1].position, {0, 1, 3});   // the hinge
    expect_near(v[2].position, {-1, 1, 3});  // was one unit above it, now one to the left
    expect_near(v[2].normal, {0, 1, 0});
    expect_near(vec3(v[2].tangent), {-1, 0, 0});
    // The mean of (0, 1.5, 3) and (-0.5, 1, 3); the normal is halfway between x and y.
    expect_near(v[3].position, {-0.25f, 1.25f, 3});
    expect_near(v[3].normal, vec3(std::sqrt(0.5f), std::sqrt(0.5f), 0));
}

TEST(Skins, MirroringJointsTurnTheWinding) {
    Scene scene = bent_scene();
    scene.nodes[1].rest->scale = vec3(-1, 1, 1);
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    EXPECT_TRUE(scene.nodes[0].skin_mirrors);
    expect_near(scene.meshes[0].primitives[0].vertices[0].normal, {-1, 0, 0});
    Diagnostics diagnostics;
    EXPECT_EQ(flatten(scene, {}, {}, diagnostics).instances[0].flags, kInstanceFlipped);
}

bool same_bytes(const Primitive& a, const Primitive& b) {
    return a.vertices.size() == b.vertices.size() &&
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vertex)) ==
               0;
}

TEST(Posing, LeavesNothingBehind) {
    Scene fresh = bent_scene(), used = bent_scene();
    for (const double t : {0.3, 5.0, 0.7, -1.0})
        ASSERT_TRUE(pose_scene(used, PoseTime{{0}, t}));
    for (const double t : {0.4, 1.0}) {
        ASSERT_TRUE(pose_scene(fresh = bent_scene(), PoseTime{{0}, t}));
        ASSERT_TRUE(pose_scene(used, PoseTime{{0}, t}));
        EXPECT_TRUE(same_bytes(fresh.meshes[0].primitives[0], used.meshes[0].primitives[0]));
    }
    ASSERT_TRUE(pose_scene(fresh = bent_scene(), std::nullopt));
    ASSERT_TRUE(pose_scene(used, std::nullopt));
    EXPECT_TRUE(same_bytes(fresh.meshes[0].primitives[0], used.meshes[0].primitives[0]));
    EXPECT_EQ(fresh.nodes[2].local, used.nodes[2].local);
}

// One vertex, two targets.
Scene morphed_scene() {
    auto d = std::make_shared<Deformation>();
    d->rest = {vertex({1, 2, 3}, {0, 0, 1})};
    d->rest_extras = {{vec2(0), vec4(0.5f, 0.5f, 0.5f, 1)}};
    d->targets.resize(2);
    d->targets[0].positions = {{0, {1, 0, 0}}};
    d->targets[0].normals = {{0, {0, 1, 0}}};
    d->targets[0].tangents = {{0, {1, 0, 0}}};
    d->targets[0].colors = {{0, vec4(1, -1, 0.25f, 0)}};
    d->targets[1].positions = {{0, {0, 10, 0}}};
    d->targets[1].uv0 = {{0, {0.5f, 0.25f}}};
    d->targets[1].uv1 = {{0, {1, 2}}};
    Primitive p;
    p.deformation = d;
    Scene scene;
    scene.meshes.push_back({"morphed", {p}, {0.5f, 0.25f}});
    const int node = add_node(scene, kUnset, {});
    scene.nodes[std::size_t(node)].mesh = 0;
    Animation a{"weights", {}, {}};
    a.samplers.push_back({Interpolation::step, {0}, {1, -1}});
    a.channels.push_back({0, 0, AnimatedProperty::weights});
    scene.animations.push_back(a);
    return scene;
}

TEST(Morphing, WeightsOfMeshNodeAndAnimation) {
    Scene scene = morphed_scene();
    const Primitive& p = scene.meshes[0].primitives[0];
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    expect_near(p.vertices[0].position, {1.5f, 4.5f, 3});
    scene.nodes[0].weights = {0, 1};
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    expect_near(p.vertices[0].position, {1, 12, 3});
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 0}));
    expect_near(p.vertices[0].position, {2, -8, 3});
}

TEST(Morphing, EveryAttribute) {
    Scene scene = morphed_scene();
    scene.nodes[0].weights = {1, 2};
    ASSERT_TRUE(pose_scene(scene, std::nullopt));
    const Vertex& v = scene.meshes[0].primitives[0].vertices[0];
    const VertexExtra& e = scene.meshes[0].primitives[0].extras[0];
    const float s = std::sqrt(0.5f);
    expect_near(v.normal, {0, s, s});
    expect_near(vec3(v.tangent), {s, s, 0});
    EXPECT_EQ(v.tangent.w, 1.0f);
    EXPECT_EQ(v.uv0, vec2(1, 0.5f));
    EXPECT_EQ(e.uv1, vec2(2, 4));
    EXPECT_EQ(e.color, vec4(1, 0, 0.75f, 1));  // clamped
}

TEST(Posing, OverflowIsAnError) {
    Scene scene = morphed_scene();
    scene.nodes[0].weights = {0, 3e38f};
    scene.nodes[0].index = 3;
    const auto posed = pose_scene(scene, std::nullopt);
    ASSERT_FALSE(posed);
    EXPECT_EQ(posed.error().kind, ErrorKind::invalid);
    EXPECT_EQ(posed.error().location, "/nodes/3");
}

TEST(Posing, AnimationsByNameAndIndex) {
    Scene scene = morphed_scene();
    scene.animations.push_back({"0", {}, {}});
    EXPECT_EQ(find_animation(scene, "weights").value(), 0u);
    EXPECT_EQ(find_animation(scene, "1").value(), 1u);
    EXPECT_EQ(find_animation(scene, "0").value(), 1u);  // names take precedence over indices
    for (const char* unknown : {"2", "", "-1", "weight"}) {
        const auto found = find_animation(scene, unknown);
        ASSERT_FALSE(found) << unknown;
        EXPECT_EQ(found.error().kind, ErrorKind::invalid_argument);
    }
}

}  // namespace
}  // namespace hm
