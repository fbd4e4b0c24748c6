#include "reference/scenes.h"

#include <array>
#include <cmath>

#include "scene/camera.h"
#include "support/scenes.h"

namespace hm::test {
namespace {

constexpr float kDegree = 0.01745329252f;

Vertex corner(vec3 position, vec2 uv = vec2(0)) {
    return {position, vec3(0), vec4(0), uv};
}

// Counter-clockwise seen from the front.
Primitive quad(const std::array<vec3, 4>& p, int material) {
    Primitive primitive;
    primitive.vertices = {corner(p[0]), corner(p[1]), corner(p[2]), corner(p[3])};
    primitive.triangles = {{0, 1, 2}, {0, 2, 3}};
    primitive.material = material;
    return primitive;
}

// The quad's first corner gets (left, bottom), its third (right, top); v grows downwards.
Primitive textured_quad(const std::array<vec3, 4>& p, int material, float left, float top,
                        float right, float bottom) {
    Primitive primitive = quad(p, material);
    const vec2 uv[4] = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    for (std::size_t i = 0; i < 4; ++i)
        primitive.vertices[i].uv0 = uv[i];
    return primitive;
}

void split_triangle(Primitive& out, vec3 a, vec3 b, vec3 c, int times) {
    if (times == 0) {
        const auto first = std::uint32_t(out.vertices.size());
        for (const vec3 p : {a, b, c})
            out.vertices.push_back(corner(p));
        out.triangles.emplace_back(first, first + 1, first + 2);
        return;
    }
    const vec3 ab = normalize(a + b), bc = normalize(b + c), ca = normalize(c + a);
    split_triangle(out, a, ab, ca, times - 1);
    split_triangle(out, ab, b, bc, times - 1);
    split_triangle(out, ca, bc, c, times - 1);
    split_triangle(out, ab, bc, ca, times - 1);
}

// A faceted ball, flat so that both renderers know the same normals: an octahedron split twice.
Primitive ball(vec3 center, float radius, int material) {
    Primitive p;
    p.material = material;
    for (int octant = 0; octant < 8; ++octant) {
        const vec3 x((octant & 1) != 0 ? -1 : 1, 0, 0);
        const vec3 y(0, (octant & 2) != 0 ? -1 : 1, 0);
        const vec3 z(0, 0, (octant & 4) != 0 ? -1 : 1);
        const bool mirrored = x.x * y.y * z.z < 0;
        split_triangle(p, x, mirrored ? z : y, mirrored ? y : z, 2);
    }
    for (Vertex& v : p.vertices)
        v.position = center + radius * v.position;
    return p;
}

// A box without its floor, turned about +y.
void add_block(SceneBuilder& builder, vec3 center, vec3 half, float degrees, int material) {
    const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    std::vector<Primitive> faces = {quad({-x - z + y, -x + z + y, x + z + y, x - z + y}, material)};
    for (const vec3 n : {x, -x, z, -z}) {
        const vec3 u = cross(y, n);
        faces.push_back(quad({n - u - y, n + u - y, n + u + y, n - u + y}, material));
    }
    glm::mat4 transform = glm::translate(glm::mat4(1), center);
    transform = glm::rotate(transform, degrees * kDegree, y);
    builder.place(builder.mesh(std::move(faces)), glm::scale(transform, half));
}

int lambert(SceneBuilder& builder, vec3 albedo, vec3 emissive = vec3(0)) {
    Material m = lambertian(albedo);
    m.emissive_factor = emissive;
    return builder.material(m);
}

Material gltf_material(vec3 base, float metallic, float roughness) {
    Material m;
    m.base_color = vec4(base, 1);
    m.metallic = metallic;
    m.roughness = roughness;
    return m;
}

int gltf(SceneBuilder& builder, vec3 base, float metallic, float roughness) {
    return builder.material(gltf_material(base, metallic, roughness));
}

CameraData view(vec3 eye, vec3 target, float vertical_degrees) {
    return camera_look_at(eye, target, vec3(0, 1, 0), vertical_degrees * kDegree,
                          float(kReferenceWidth) / float(kReferenceHeight));
}

// Bands by height, stripes around, and a bright patch in a quarter of the sky.
EnvironmentMap sky(float rotation = 0, float intensity = 1) {
    std::vector<vec3> texels;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x) {
            const float band = 0.2f + 0.05f * float(15 - y);
            const float stripe = 0.1f * float((3 * x + 5 * y) % 7);
            const float sun = x >= 20 && x <= 22 && y >= 3 && y <= 4 ? 6.0f : 0.0f;
            texels.emplace_back(band + stripe + sun, band + 0.5f * stripe + 0.8f * sun,
                                1.4f * band + 0.5f * sun);
        }
    return make_environment(environment_image(32, 16, texels), rotation, intensity);
}

TextureSlot slot(int image, std::uint32_t wrap) {
    TextureSlot s;
    s.image = image;
    s.wrap_u = s.wrap_v = wrap;
    return s;
}

}  // namespace

ReferenceCase reference_box() {
    SceneBuilder b;
    const int white = lambert(b, {0.725f, 0.71f, 0.68f});
    const float x = 1.5f, y = 2, z = 2;
    const std::vector<Primitive> room = {
        quad({vec3(-x, 0, z), {x, 0, z}, {x, 0, -z}, {-x, 0, -z}}, white),
        quad({vec3(-x, y, -z), {x, y, -z}, {x, y, z}, {-x, y, z}}, white),
        quad({vec3(-x, 0, -z), {x, 0, -z}, {x, y, -z}, {-x, y, -z}}, white),
        quad({vec3(x, 0, z), {-x, 0, z}, {-x, y, z}, {x, y, z}}, white),
        quad({vec3(-x, 0, z), {-x, 0, -z}, {-x, y, -z}, {-x, y, z}},
             lambert(b, {0.63f, 0.065f, 0.05f})),
        quad({vec3(x, 0, -z), {x, 0, z}, {x, y, z}, {x, y, -z}},
             lambert(b, {0.14f, 0.45f, 0.091f})),
        quad({vec3(-0.4f, 1.98f, -0.5f),
              {0.4f, 1.98f, -0.5f},
              {0.4f, 1.98f, 0.3f},
              {-0.4f, 1.98f, 0.3f}},
             lambert(b, vec3(0.5f), {12, 9, 6})),
    };
    b.place(b.mesh(room));
    add_block(b, {-0.5f, 0.6f, -0.9f}, {0.35f, 0.6f, 0.35f}, 20, white);
    add_block(b, {0.5f, 0.3f, -0.1f}, {0.3f, 0.3f, 0.3f}, -18, white);
    return {b.scene, {}, view({0.2f, 1.1f, 1.9f}, {0, 0.8f, -1}, 60), 8};
}

ReferenceCase reference_metal() {
    SceneBuilder b;
    b.place(b.mesh({quad({vec3(-4, 0, 4), {4, 0, 4}, {4, 0, -4}, {-4, 0, -4}},
                         lambert(b, {0.5f, 0.45f, 0.4f}))}));
    const float roughness[] = {0.3f, 0.5f, 0.8f};
    for (int i = 0; i < 3; ++i)
        b.place(b.mesh(
            {ball({1.6f * float(i - 1), 0.75f, 0}, 0.7f, gltf(b, vec3(1), 1, roughness[i]))}));
    return {b.scene, sky(), view({0, 2, 5}, {0, 0.6f, 0}, 38), 0};
}

ReferenceCase reference_materials() {
    SceneBuilder b;
    const float roughness[] = {1.0f, 0.6f, 0.3f};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const int material = gltf(b, {0.8f, 0.5f, 0.2f}, 0.5f * float(i), roughness[j]);
            b.place(b.mesh({ball({1.1f * float(i - 1), 1.1f * float(j - 1), 0}, 0.48f, material)}));
        }
    b.place(b.mesh({quad({vec3(-3, -2, -0.8f), {3, -2, -0.8f}, {3, 2, -0.8f}, {-3, 2, -0.8f}},
                         gltf(b, {0.3f, 0.4f, 0.6f}, 0, 0.4f)),
                    quad({vec3(-2, 1, 2.9f), {-2.6f, 1, 2}, {-2.6f, 2.2f, 2}, {-2, 2.2f, 2.9f}},
                         lambert(b, vec3(0.2f), {14, 15, 18}))}));
    return {b.scene, sky(75, 0.5f), view({0, 0, 6}, {0, 0, 0}, 36), 4};
}

ReferenceCase reference_punctual() {
    SceneBuilder b;
    b.place(b.mesh(
        {quad({vec3(-3, 0, 3), {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}, lambert(b, {0.6f, 0.6f, 0.5f})),
         quad({vec3(-3, 0, -2), {3, 0, -2}, {3, 3, -2}, {-3, 3, -2}},
              lambert(b, {0.4f, 0.5f, 0.7f})),
         ball({-0.8f, 0.6f, 0}, 0.55f, lambert(b, {0.8f, 0.3f, 0.2f})),
         ball({0.9f, 0.5f, 0.4f}, 0.45f, gltf(b, {0.2f, 0.6f, 0.3f}, 0, 0.5f))}));
    const auto facing = [](vec3 position, vec3 direction) {
        return glm::inverse(glm::lookAt(position, position + direction, vec3(0, 1, 0)));
    };
    Light point;
    point.color = {6, 4, 3};
    b.light(point, glm::translate(glm::mat4(1), vec3(-1.8f, 2.2f, 1.2f)));
    Light directional;
    directional.kind = kLightDirectional;
    directional.color = {0.5f, 0.6f, 0.9f};
    b.light(directional, facing(vec3(0), {-0.6f, -1, -0.4f}));
    Light spot;
    spot.kind = kLightSpot;
    spot.color = {7, 8, 4.5f};
    spot.intensity = 2;
    spot.range = 5;
    spot.inner_cone = 0.25f;
    spot.outer_cone = 0.5f;
    b.light(spot, facing({1, 3, 1.5f}, {-0.3f, -1, -0.5f}));
    return {b.scene, {}, view({0.5f, 2.2f, 4}, {0, 0.4f, 0}, 42), 3};
}

ReferenceCase reference_lens() {
    SceneBuilder b;
    std::vector<vec4> texels;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            texels.push_back(
                vec4(float(40 + 50 * x), float(220 - 45 * y), float(30 + 13 * (x * y)), 255) /
                255.0f);
    const int image = b.image(4, 4, texels);
    Material floor = lambertian(vec3(1)), card = floor;
    floor.base_color_texture = slot(image, kWrapRepeat);
    card.base_color_texture = slot(image, kWrapClamp);
    const int floor_id = b.material(floor), card_id = b.material(card);
    b.place(b.mesh({textured_quad({vec3(-6, 0, 3), {6, 0, 3}, {6, 0, -9}, {-6, 0, -9}}, floor_id,
                                  -1, -2, 3.5f, 2.25f)}));
    const float depths[] = {1.5f, 0, -2, -5};
    for (int i = 0; i < 4; ++i) {
        const float x = -1.2f + 0.9f * float(i), z = depths[i];
        b.place(b.mesh({textured_quad(
            {vec3(x, 0.1f, z), {x + 0.8f, 0.1f, z}, {x + 0.8f, 1.3f, z}, {x, 1.3f, z}}, card_id,
            -0.1f, -0.1f, 1.2f, 1.1f)}));
    }
    ReferenceCase c{b.scene, sky(-30), view({0.3f, 1, 4}, {0, 0.5f, 0}, 40), 2};
    c.camera.lens_radius = 0.3f;
    c.camera.focus_distance = 4.2f;
    return c;
}

ReferenceCase reference_transparency() {
    SceneBuilder b;
    b.place(b.mesh(
        {quad({vec3(-3, 0, 3), {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}}, lambert(b, {0.5f, 0.6f, 0.7f})),
         ball({0, 0.6f, -1}, 0.55f, lambert(b, {0.8f, 0.2f, 0.1f}))}));
    std::vector<vec4> texels;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            texels.emplace_back(1, 1, 1, float(20 + 60 * x + 13 * y) / 255.0f);
    const int image = b.image(4, 4, texels);
    Material even = gltf_material({0.2f, 0.7f, 0.3f}, 0, 0.4f);
    even.base_color.w = 0.35f;
    even.alpha_mode = kAlphaBlend;
    Material patterned = gltf_material({0.9f, 0.8f, 0.3f}, 1, 0.5f);
    patterned.base_color_texture = slot(image, kWrapRepeat);
    patterned.alpha_mode = kAlphaBlend;
    Material cut = lambertian({0.3f, 0.3f, 0.8f});
    cut.base_color_texture = slot(image, kWrapRepeat);
    cut.base_color_texture.filter_mode = kFilterNearest;
    cut.alpha_mode = kAlphaMask;
    const std::pair<vec2, Material> cards[] = {
        {{-1.9f, 0.3f}, even}, {{-0.6f, 0.5f}, patterned}, {{0.7f, 0.4f}, cut}};
    for (const auto& [at, material] : cards) {
        const float x = at.x, z = at.y;
        b.place(b.mesh({textured_quad({vec3(x, 0.1f, z),
                                       {x + 1.1f, 0.1f, z + 0.4f},
                                       {x + 1.1f, 1.4f, z + 0.4f},
                                       {x, 1.4f, z}},
                                      b.material(material), 0, 0, 1, 1)}));
    }
    return {b.scene, sky(120, 0.8f), view({0.3f, 1.6f, 4.5f}, {0, 0.5f, 0}, 36), 0};
}

}  // namespace hm::test
