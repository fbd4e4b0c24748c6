#include "gpu/extended_scene.h"

#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera.h"
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

Material glass(vec3 color, float roughness, float thickness) {
    Material m = paint(color, roughness);
    m.transmission = 1;
    m.thickness = thickness;
    return m;
}

// A texture of smooth numbers in all four channels.
int add_ramp(SceneBuilder& b) {
    std::vector<vec4> texels;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            texels.emplace_back(0.3f + 0.08f * float(x), 0.9f - 0.07f * float(y),
                                0.5f + 0.03f * float(x + y), 1 - 0.05f * float(y));
    return b.image(8, 8, texels);
}

std::vector<Material> opaque_looks(int ramp) {
    std::vector<Material> looks;
    Material coat = paint({0.6f, 0.1f, 0.1f}, 0.6f);
    coat.clearcoat = 1;
    coat.clearcoat_roughness = 0.1f;
    coat.clearcoat_normal_texture.image = ramp;
    coat.clearcoat_texture.image = ramp;
    looks.push_back(coat);
    Material cloth = paint({0.1f, 0.1f, 0.3f}, 1);
    cloth.sheen_color = {0.9f, 0.8f, 0.7f};
    cloth.sheen_roughness = 0.4f;
    cloth.sheen_color_texture.image = ramp;
    looks.push_back(cloth);
    Material brushed = paint({0.9f, 0.8f, 0.6f}, 0.3f);
    brushed.metallic = 1;
    brushed.anisotropy = 0.8f;
    brushed.anisotropy_rotation = 0.7f;
    brushed.anisotropy_texture.image = ramp;
    looks.push_back(brushed);
    Material film = paint({0.2f, 0.2f, 0.2f}, 0.15f);
    film.iridescence = 1;
    film.iridescence_thickness_texture.image = ramp;
    film.metallic = 0.5f;
    looks.push_back(film);
    Material tinted = paint({0.1f, 0.4f, 0.2f}, 0.3f);
    tinted.specular_color = {1, 0.5f, 0.2f};
    tinted.specular_texture.image = ramp;
    tinted.ior = 2;
    tinted.emissive_factor = {0.2f, 0.1f, 0.3f};
    tinted.clearcoat = 0.8f;
    looks.push_back(tinted);
    Material glossy = paint({0.5f, 0.3f, 0.1f}, 0.2f);
    glossy.specular_color = {0.4f, 0.4f, 0.2f};
    glossy.specular_color_texture.image = ramp;
    glossy.specular_glossiness = true;
    looks.push_back(glossy);
    return looks;
}

std::vector<Material> clear_looks(int ramp) {
    std::vector<Material> looks = {glass({0.9f, 0.95f, 1}, 0, 1), glass(vec3(1), 0.3f, 1),
                                   glass({0.8f, 0.9f, 0.8f}, 0.2f, 0)};
    looks[0].dispersion = 2;
    looks[1].attenuation_distance = 0.3f;
    looks[1].attenuation_color = {0.3f, 0.8f, 0.5f};
    looks[2].transmission_texture.image = ramp;
    Material leaf = paint({0.2f, 0.5f, 0.1f}, 0.5f);
    leaf.diffuse_transmission = 0.7f;
    leaf.diffuse_transmission_color = {0.6f, 0.9f, 0.2f};
    leaf.diffuse_transmission_texture.image = ramp;
    leaf.double_sided = true;
    looks.push_back(leaf);
    return looks;
}

}  // namespace

ExtendedScene::ExtendedScene() {
    SceneBuilder b;
    const int ramp = add_ramp(b);
    b.place(add_cube(b, true, b.material(paint(vec3(0.7f), 0.8f))), at(vec3(0), 2));
    float x = -1.5f;
    for (const Material& look : opaque_looks(ramp)) {
        b.place(b.sphere(20, b.material(look)), at({x, -1.2f, -0.8f}, 0.28f));
        x += 0.6f;
    }
    x = -1.3f;
    for (const Material& look : clear_looks(ramp)) {
        b.place(b.sphere(20, b.material(look)), at({x, -0.2f, -0.5f}, 0.4f));
        x += 0.9f;
    }
    // A bubble of water that reaches into the glass around it, and a volume that the camera is in.
    Material water = glass(vec3(1), 0, 1);
    water.ior = 1.33f;
    b.place(b.sphere(20, b.material(glass(vec3(1), 0, 1))), at({0, 0.9f, -0.5f}, 0.5f));
    b.place(b.sphere(20, b.material(water)), at({0.2f, 0.9f, -0.5f}, 0.45f));
    Material fog = glass(vec3(1), 0, 1);
    fog.ior = 1;
    fog.attenuation_distance = 4;
    fog.attenuation_color = {0.9f, 0.7f, 0.6f};
    b.place(add_cube(b, false, b.material(fog)), at(vec3(0), 1.95f));
    b.place(b.quad(vec3(-0.6f, 1.9f, -0.6f), vec3(1.2f, 0, 0), vec3(0, 0, 1.2f),
                   b.material(emitter(vec3(6)))));
    Light lamp;
    lamp.intensity = 2;
    b.light(lamp, at({1, 1.2f, 1}, 1));
    scene = b.scene;
    prepare_tangents(scene);
    flat = flatten_quietly(scene);
    camera = camera_look_at({0.2f, 0, 1.8f}, {0, -0.2f, 0}, {0, 1, 0}, 1.2f, 1);
}

}  // namespace hm::test
