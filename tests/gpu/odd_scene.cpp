#include "gpu/odd_scene.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera.h"
#include "scene/pose.h"
#include "scene/tangents.h"
#include "support/scenes.h"

namespace hm::test {

namespace {

glm::mat4 at(vec3 position, float scale) {
    return glm::scale(glm::translate(glm::mat4(1), position), vec3(scale));
}

Material paint(vec3 color, float roughness) {
    Material m;
    m.base_color = vec4(color, 1);
    m.metallic = 0;
    m.roughness = roughness;
    return m;
}

// The primitive's vertices become the rest of a deformation.
Deformation& deformed(Primitive& p) {
    const auto d = std::make_shared<Deformation>();
    d->rest = p.vertices;
    p.deformation = d;
    return *d;
}

// A sphere that its one target pulls upwards, by half.
void add_morphed(SceneBuilder& b, int material) {
    const int mesh = b.sphere(24, material);
    Mesh& m = b.scene.meshes[std::size_t(mesh)];
    Deformation& d = deformed(m.primitives[0]);
    MorphTarget& target = d.targets.emplace_back();
    for (std::uint32_t v = 0; v < d.rest.size(); ++v)
        if (d.rest[v].position.y > 0)
            target.positions.push_back({v, vec3(0, 2 * d.rest[v].position.y, 0)});
    m.weights = {0.5f};
    b.place(mesh, at({-1.2f, -1.5f, 0}, 0.5f));
}

// A sphere whose upper half follows a joint that leans and mirrors.
void add_skinned(SceneBuilder& b, int material) {
    const int mesh = b.sphere(24, material);
    Deformation& d = deformed(b.scene.meshes[std::size_t(mesh)].primitives[0]);
    d.influences = 2;
    for (const Vertex& v : d.rest) {
        const float upper = std::min(std::max(0.5f + v.position.y, 0.0f), 1.0f);
        d.joints.insert(d.joints.end(), {0, 1});
        d.weights.insert(d.weights.end(), {1 - upper, upper});
    }
    const auto add_joint = [&](const glm::mat4& local) {
        Node joint;
        joint.local = local;
        b.scene.nodes.push_back(joint);
        return int(b.scene.nodes.size()) - 1;
    };
    const glm::mat4 place = at({1.2f, -1.3f, -0.3f}, 0.6f);
    const glm::mat4 lean = glm::rotate(place, 0.5f, vec3(0, 0, 1));
    Skin skin;
    skin.joints = {add_joint(place), add_joint(lean)};
    skin.inverse_bind = {glm::mat4(1), glm::mat4(1)};
    b.scene.skins.push_back(skin);
    const int wearer = b.place(mesh);
    b.scene.nodes[std::size_t(wearer)].skin = 0;
}

void add_placed(SceneBuilder& b, int material, int glass) {
    const int cube = add_cube(b, false, material);
    const int wearer = b.place(cube, at({0, -1.8f, 0.8f}, 1));
    for (int i = 0; i < 4; ++i)
        b.scene.nodes[std::size_t(wearer)].instances.push_back(glm::rotate(
            at({0.5f * float(i) - 0.75f, 0, 0}, 0.15f), 0.3f * float(i), vec3(0, 1, 0)));
    const int twice = add_cube(b, false, material);
    const int layered = b.sphere(16, glass);
    for (int i = 0; i < 2; ++i) {
        b.place(twice, at({0, -0.2f, -1.2f}, 0.3f));
        b.place(layered, at({0.3f, 0.6f, -0.3f}, 0.4f));
    }
    const int huge = b.sphere(24, material);
    for (Vertex& v : b.scene.meshes[std::size_t(huge)].primitives[0].vertices)
        v.position *= 1e11f;
    b.place(huge, at({-0.6f, 0.7f, -0.8f}, 0.4e-11f));
}

// Triangles without area, one of them with a NaN vertex, before the others.
void add_degenerates(SceneBuilder& b, int material) {
    Primitive p =
        b.quad_primitive({-0.3f, -0.9f, 0.2f}, {0.6f, 0.1f, 0}, {0, 0.5f, -0.2f}, material);
    p.triangles.insert(p.triangles.begin(), {{0, 0, 1}, {1, 1, 1}, {0, 2, 2}});
    b.place(b.mesh({p}));
}

// A smooth ramp of 16 bits, read as colours.
int add_deep_image(Scene& scene) {
    constexpr std::uint32_t kSize = 16;
    Image16 image(kSize, kSize);
    for (std::uint32_t y = 0; y < kSize; ++y)
        for (std::uint32_t x = 0; x < kSize; ++x) {
            const auto ramp = [](std::uint32_t i) { return std::uint16_t(1234 + 4001 * i); };
            image.pixels[y * kSize + x] = {ramp(x), ramp(y), ramp(kSize - 1 - x), 65535};
        }
    scene.images.push_back(image);
    return int(scene.images.size()) - 1;
}

}  // namespace

OddScene::OddScene() {
    SceneBuilder b;
    Material deep = paint(vec3(1), 0.5f);
    deep.base_color_texture.image = add_deep_image(b.scene);
    Material glass = paint({0.4f, 0.7f, 0.9f}, 0.2f);
    glass.alpha_mode = kAlphaBlend;
    glass.base_color.w = 0.4f;
    glass.double_sided = true;
    const int wall = b.material(deep);
    const int red = b.material(paint({0.7f, 0.15f, 0.1f}, 0.3f));
    const int gold = b.material(paint({0.8f, 0.6f, 0.2f}, 0.25f));
    b.place(add_cube(b, true, wall), at(vec3(0), 2));
    add_morphed(b, red);
    add_skinned(b, gold);
    add_placed(b, gold, b.material(glass));
    add_degenerates(b, red);
    b.place(b.quad(vec3(-0.6f, 1.98f, -0.6f), vec3(1.2f, 0, 0), vec3(0, 0, 1.2f),
                   b.material(emitter(vec3(6)))));
    scene = b.scene;
    prepare_tangents(scene);
    (void)pose_scene(scene, std::nullopt);
    flat = flatten_quietly(scene);
    camera = camera_look_at({0.2f, 0, 1.9f}, {0, -0.3f, 0}, {0, 1, 0}, 1.2f, 1);
}

}  // namespace hm::test
