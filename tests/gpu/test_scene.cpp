// The scene of path_tracer.h's TestScene: a box of four by four by four metres, open to the front.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "gpu/path_tracer.h"
#include "scene/camera.h"
#include "scene/render_params.h"
#include "scene/tangents.h"

namespace hm::test {

namespace {

enum ImageIndex { kChecker, kBumps, kCutOut, kRoughness, kPattern };
enum MaterialIndex { kRed, kChecked, kBumpy, kMetal, kMasked, kGlassy, kLamp, kSign, kUnlit };

// Texels of the given function of (x, y) -> rgba.
template <class Function>
Image8 make_image(std::uint32_t size, Function texel) {
    Image8 image(size, size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            const std::array<int, 4> channels = texel(x, y);
            std::copy(channels.begin(), channels.end(),
                      image.pixels[std::size_t(y) * size + x].begin());
        }
    return image;
}

void add_images(Scene& scene) {
    using Texel = std::array<int, 4>;
    std::mt19937 random(7);
    const auto any = [&random](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    scene.images.push_back(make_image(8, [](std::uint32_t x, std::uint32_t y) {
        return (x + y) % 2 == 0 ? Texel{230, 220, 200, 255} : Texel{40, 60, 120, 255};
    }));
    scene.images.push_back(make_image(16, [&](std::uint32_t, std::uint32_t) {
        return Texel{any(70, 185), any(70, 185), 255, 255};
    }));
    scene.images.push_back(make_image(4, [](std::uint32_t x, std::uint32_t y) {
        return Texel{200, 180, 60, (x + y) % 2 == 0 ? 255 : 60};
    }));
    scene.images.push_back(make_image(8, [&](std::uint32_t, std::uint32_t) {
        return Texel{0, any(60, 255), any(100, 255), 255};
    }));
    scene.images.push_back(make_image(4, [&](std::uint32_t, std::uint32_t) {
        return Texel{any(0, 255), any(0, 255), any(0, 255), 255};
    }));
}

TextureSlot slot(ImageIndex image, std::uint32_t wrap, float repeats) {
    TextureSlot slot;
    slot.image = image;
    slot.wrap_u = slot.wrap_v = wrap;
    slot.uv_row_u = {repeats * 0.9f, repeats * 0.2f, 0.15f};
    slot.uv_row_v = {-0.2f * repeats, repeats * 0.9f, -0.35f};
    return slot;
}

void add_materials(Scene& scene) {
    scene.materials.resize(kUnlit + 1);
    scene.materials[kRed].base_color = {0.6f, 0.1f, 0.08f, 1};
    scene.materials[kRed].metallic = 0;
    scene.materials[kRed].specular_weight = 0;

    scene.materials[kChecked].base_color_texture = slot(kChecker, kWrapRepeat, 3);
    scene.materials[kChecked].metallic = 0;
    scene.materials[kChecked].roughness = 0.4f;

    scene.materials[kBumpy].normal_texture = slot(kBumps, kWrapMirror, 2);
    scene.materials[kBumpy].normal_scale = 0.7f;
    scene.materials[kBumpy].metallic = 0.2f;
    scene.materials[kBumpy].roughness = 0.3f;

    scene.materials[kMetal].base_color = {0.9f, 0.7f, 0.4f, 1};
    scene.materials[kMetal].metallic_roughness_texture = slot(kRoughness, kWrapRepeat, 1);
    scene.materials[kMetal].metallic_roughness_texture.uv_set = 1;

    scene.materials[kMasked].base_color_texture = slot(kCutOut, kWrapClamp, 1.5f);
    scene.materials[kMasked].base_color_texture.filter_mode = kFilterNearest;
    scene.materials[kMasked].alpha_mode = kAlphaMask;
    scene.materials[kMasked].double_sided = true;
    scene.materials[kMasked].metallic = 0;

    scene.materials[kGlassy].base_color = {0.3f, 0.8f, 0.4f, 0.6f};
    scene.materials[kGlassy].alpha_mode = kAlphaBlend;
    scene.materials[kGlassy].metallic = 0;
    scene.materials[kGlassy].roughness = 0.1f;
    scene.materials[kGlassy].double_sided = true;

    scene.materials[kLamp].emissive_factor = {9, 8, 6};
    scene.materials[kLamp].metallic = 0;

    scene.materials[kSign].emissive_factor = {2, 2, 2};
    scene.materials[kSign].emissive_texture = slot(kPattern, kWrapRepeat, 1);
    scene.materials[kSign].double_sided = true;

    scene.materials[kUnlit].base_color = {0.2f, 0.5f, 0.7f, 1};
    scene.materials[kUnlit].unlit = true;
}

// A unit square in x and y, facing +z, with everything a primitive can have.
Mesh square(MaterialIndex material) {
    Primitive p;
    p.material = material;
    p.has_normals = p.has_tangents = true;
    for (const vec2 c : {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1)}) {
        Vertex v{};
        v.position = {c.x, c.y, 0};
        v.normal = normalize(vec3(0.2f * c.x, 0.2f * c.y, 1));
        v.tangent = {1, 0, 0, 1};
        v.uv0 = {0.5f + 0.5f * c.x, 0.5f - 0.5f * c.y};
        p.vertices.push_back(v);
        p.extras.push_back({v.uv0 * 2.0f, {1, 0.8f + 0.2f * c.x, 0.9f, 0.9f + 0.1f * c.y}});
    }
    p.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {"", {p}};
}

// A cube with flat faces: no normals, tangents made, no extras; and a lid of another material.
Mesh cube(MaterialIndex sides, MaterialIndex lid) {
    Mesh mesh{"", {Primitive{}, Primitive{}}};
    mesh.primitives[0].material = sides;
    mesh.primitives[1].material = lid;
    const glm::mat4 up = glm::rotate(glm::mat4(1), -1.5707963f, vec3(1, 0, 0));
    for (int face = 0; face < 6; ++face) {
        const glm::mat4 turn =
            face < 4 ? glm::rotate(glm::mat4(1), 1.5707963f * float(face), vec3(0, 1, 0))
                     : glm::rotate(up, 3.1415927f * float(face - 4), vec3(1, 0, 0));
        Primitive& p = mesh.primitives[face == 4 ? 1 : 0];
        const auto first = static_cast<std::uint32_t>(p.vertices.size());
        for (const vec2 c : {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1)}) {
            Vertex v{};
            v.position = vec3(turn * vec4(c.x, c.y, 1, 1));
            v.uv0 = {0.5f + 0.5f * c.x, 0.5f - 0.5f * c.y};
            p.vertices.push_back(v);
        }
        p.triangles.emplace_back(first, first + 1, first + 2);
        p.triangles.emplace_back(first, first + 2, first + 3);
    }
    return mesh;
}

void place(Scene& scene, Mesh mesh, const glm::mat4& local) {
    Node node;
    node.mesh = static_cast<int>(scene.meshes.size());
    node.local = local;
    scene.meshes.push_back(std::move(mesh));
    scene.nodes.push_back(node);
}

glm::mat4 at(vec3 position, vec3 axis, float degrees, vec3 scale) {
    const glm::mat4 moved = glm::translate(glm::mat4(1), position);
    return glm::scale(glm::rotate(moved, glm::radians(degrees), axis), scale);
}

void add_objects(Scene& scene) {
    const vec3 x(1, 0, 0);
    const vec3 y(0, 1, 0);
    place(scene, square(kChecked), at({0, -2, 0}, x, -90, {2, 2, 1}));
    place(scene, square(kBumpy), at({0, 0, -2}, y, 0, {2, 2, 1}));
    place(scene, square(kRed), at({-2, 0, 0}, y, 90, {2, 2, 1}));
    place(scene, square(kMetal), at({2, 0, 0}, y, -90, {2, 2, 1}));
    place(scene, square(kLamp), at({0, 1.9f, 0}, x, 90, {0.6f, 0.6f, 1}));
    place(scene, square(kSign), at({-1.2f, 0.8f, -1.9f}, y, 10, {0.5f, 0.5f, 1}));
    place(scene, square(kMasked), at({0.9f, -0.2f, 0.6f}, y, 25, {0.6f, 0.8f, 1}));
    place(scene, square(kGlassy), at({-0.9f, -0.6f, 0.9f}, y, -20, {0.6f, 0.9f, 1}));
    place(scene, square(kUnlit), at({1.2f, 1.2f, -1.8f}, y, -15, {0.4f, 0.3f, 1}));
    // Mirrored, and stretched along one axis.
    place(scene, cube(kBumpy, kMetal), at({-0.5f, -1.4f, -0.6f}, y, 30, {-0.6f, 0.6f, 0.5f}));
    place(scene, cube(kRed, kLamp), at({1, -1.7f, -0.4f}, y, -10, {0.3f, 0.3f, 0.3f}));
}

void add_lights(Scene& scene) {
    const std::uint32_t kinds[] = {kLightPoint, kLightSpot, kLightDirectional};
    const float intensities[] = {1.5f, 6, 0.3f};
    for (std::size_t i = 0; i < 3; ++i) {
        Light light;
        light.kind = kinds[i];
        light.intensity = intensities[i];
        light.range = i == 0 ? 5.0f : 0.0f;
        light.inner_cone = 0.2f;
        light.outer_cone = 0.6f;
        Node node;
        node.light = static_cast<int>(i);
        node.local = at({-1.0f + float(i), 1, 1.5f}, {1, 0, 0}, -40 - 10 * float(i), vec3(1));
        scene.lights.push_back(light);
        scene.nodes.push_back(node);
    }
}

// A sky of bands with a sun of a few texels.
EnvironmentMap sky() {
    FloatImage image(16, 8);
    for (std::uint32_t v = 0; v < 8; ++v)
        for (std::uint32_t u = 0; u < 16; ++u) {
            const float band = 0.3f + 0.05f * float(v) + 0.03f * float(u % 3);
            const float sun = v == 2 && (u == 3 || u == 4) ? 12.0f : 0.0f;
            image.pixels[v * 16 + u] = {band + sun, band + 0.8f * sun, 1.3f * band, 1};
        }
    return make_environment(image, 35, 0.8f);
}

}  // namespace

TestScene::TestScene() {
    add_images(scene);
    add_materials(scene);
    add_objects(scene);
    add_lights(scene);
    prepare_tangents(scene);
    Diagnostics diagnostics;
    flat = flatten(scene, sky(), LightChoice{}, diagnostics);
    camera = camera_look_at({0.4f, 0.2f, 5.5f}, {0, -0.1f, 0}, {0, 1, 0}, 0.75f, 1);
}

RenderParams TestScene::params() const {
    return make_params(flat, 0, 0, {.seed = 5, .bounces = 6, .filter = PixelFilter::gaussian});
}

}  // namespace hm::test
