#include "support/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hm::test {
namespace {

std::uint8_t to_byte(float x) {
    return std::uint8_t(std::lround(std::clamp(x, 0.0f, 1.0f) * 255));
}

Vertex vertex(vec3 position, vec3 normal, vec2 uv) {
    return {position, normal, vec4(0), uv};
}

}  // namespace

Material lambertian(vec3 albedo) {
    Material m;
    m.base_color = vec4(albedo, 1);
    m.metallic = 0;
    m.specular_weight = 0;
    return m;
}

Material emitter(vec3 radiance) {
    Material m = lambertian(vec3(0));
    m.emissive_factor = radiance;
    return m;
}

int SceneBuilder::material(const Material& m) {
    scene.materials.push_back(m);
    return int(scene.materials.size()) - 1;
}

int SceneBuilder::image(std::uint32_t width, std::uint32_t height,
                        const std::vector<vec4>& texels) {
    Image8 image(width, height);
    for (std::size_t i = 0; i < texels.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k)
            image.pixels[i][k] = to_byte(texels[i][k]);
    scene.images.push_back(std::move(image));
    return int(scene.images.size()) - 1;
}

Primitive SceneBuilder::quad_primitive(vec3 corner, vec3 u, vec3 v, int material) const {
    Primitive p;
    vec3 n = normalize(cross(u, v));
    p.vertices = {vertex(corner, n, {0, 0}), vertex(corner + u, n, {1, 0}),
                  vertex(corner + u + v, n, {1, 1}), vertex(corner + v, n, {0, 1})};
    p.triangles = {{0, 1, 2}, {0, 2, 3}};
    p.material = material;
    p.has_normals = true;
    return p;
}

int SceneBuilder::quad(vec3 corner, vec3 u, vec3 v, int material) {
    return mesh({quad_primitive(corner, u, v, material)});
}

int SceneBuilder::sphere(int segments, int material) {
    Primitive p;
    p.material = material;
    p.has_normals = true;
    const int rings = segments / 2;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i <= segments; ++i) {
            float theta = std::numbers::pi_v<float> * float(j) / float(rings);
            float phi = 2 * std::numbers::pi_v<float> * float(i) / float(segments);
            vec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                   std::cos(theta));
            p.vertices.push_back(
                vertex(n, n, {float(i) / float(segments), float(j) / float(rings)}));
        }
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < segments; ++i) {
            uint a = uint(j * (segments + 1) + i), b = a + uint(segments) + 1;
            if (j > 0) p.triangles.push_back({a, b, a + 1});
            if (j + 1 < rings) p.triangles.push_back({a + 1, b, b + 1});
        }
    return mesh({p});
}

int SceneBuilder::mesh(std::vector<Primitive> primitives) {
    Mesh m;
    m.primitives = std::move(primitives);
    scene.meshes.push_back(std::move(m));
    return int(scene.meshes.size()) - 1;
}

int SceneBuilder::place(int mesh, const glm::mat4& transform) {
    Node node;
    node.mesh = mesh;
    node.local = transform;
    scene.nodes.push_back(node);
    return int(scene.nodes.size()) - 1;
}

int SceneBuilder::light(const Light& light, const glm::mat4& transform) {
    scene.lights.push_back(light);
    Node node;
    node.light = int(scene.lights.size()) - 1;
    node.local = transform;
    scene.nodes.push_back(node);
    return int(scene.nodes.size()) - 1;
}

int add_cube(SceneBuilder& builder, bool inwards, int material) {
    std::vector<Primitive> sides;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (float side : {-1.0f, 1.0f}) {
            vec3 n(0), u(0);
            n[axis] = side;
            u[(axis + 1) % 3] = 2;
            vec3 v = cross(inwards ? -n : n, u);
            sides.push_back(builder.quad_primitive(n - 0.5f * (u + v), u, v, material));
        }
    return builder.mesh(std::move(sides));
}

FloatImage environment_image(std::uint32_t width, std::uint32_t height,
                             const std::vector<vec3>& texels) {
    FloatImage image(width, height);
    for (std::size_t i = 0; i < texels.size(); ++i)
        image.pixels[i] = {texels[i].x, texels[i].y, texels[i].z, 1};
    return image;
}

EnvironmentMap constant_environment(vec3 radiance) {
    return make_environment(environment_image(1, 1, {radiance}), 0, 1);
}

FlatScene flatten_quietly(const Scene& scene, EnvironmentMap environment, LightChoice choice) {
    Diagnostics diagnostics;
    FlatScene flat = flatten(scene, std::move(environment), choice, diagnostics);
    EXPECT_TRUE(diagnostics.warnings().empty());
    return flat;
}

}  // namespace hm::test
