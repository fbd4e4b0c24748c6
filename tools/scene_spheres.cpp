// A grid of spheres: roughness increases to the right, metalness downwards. All have the base
// colour of gold, from plastic to metal. Area lamps show the shapes of highlights.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scenes.h"

namespace hm {
namespace {

constexpr std::array kMetallic = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};
constexpr std::array kRoughness = {0.04f, 0.1f, 0.2f, 0.3f, 0.45f, 0.6f, 0.8f, 1.0f};
constexpr float kRadius = 0.46f;  // metres, on a grid of one metre
constexpr glm::vec3 kGold(1.0f, 0.766f, 0.336f);

void add_spheres(GltfWriter& writer) {
    TriangleMesh sphere;
    append(sphere, make_sphere(128, 64), glm::scale(glm::mat4(1), glm::vec3(kRadius)));
    int geometry = -1;
    for (std::size_t row = 0; row < kMetallic.size(); ++row)
        for (std::size_t column = 0; column < kRoughness.size(); ++column) {
            const std::string name =
                fmt::format("metallic {} roughness {}", kMetallic[row], kRoughness[column]);
            const int material = writer.add_material(name, {.color = glm::vec4(kGold, 1),
                                                            .metallic = kMetallic[row],
                                                            .roughness = kRoughness[column]});
            const GltfPrimitive primitive = geometry < 0 ? writer.add_primitive(sphere, material)
                                                         : GltfPrimitive{geometry, material};
            geometry = primitive.geometry;
            const float x = float(column) - 0.5f * float(kRoughness.size() - 1);
            const float y = 0.5f + float(kMetallic.size() - 1 - row);
            writer.add_node({.name = name,
                             .translation = {x, y, 0},
                             .mesh = writer.add_mesh(name, {&primitive, 1})});
        }
}

// A floor that curves up into a back wall, as in a photo studio.
TriangleMesh make_backdrop() {
    const float radius = 2.5f, depth = 2.5f, front = 9, half_width = 16, height = 12;
    const float arc = radius * 1.5707963f, length = front + depth + arc + height;
    return make_surface(1, 96, [=](float s, float t) {
        const float x = half_width * (2 * s - 1);
        const float along = t * length - front;
        if (along < depth) return SurfacePoint{{x, 0, -along}, {s, -t}};
        if (along > depth + arc)
            return SurfacePoint{{x, radius + along - depth - arc, -depth - radius}, {s, -t}};
        const float angle = (along - depth) / radius;
        return SurfacePoint{{x, radius * (1 - std::cos(angle)), -depth - radius * std::sin(angle)},
                            {s, -t}};
    });
}

// A rectangular lamp that faces `target`.
void add_lamp(GltfWriter& writer, const char* name, glm::vec3 center, glm::vec3 target,
              glm::vec2 size, glm::vec3 color, float strength) {
    TriangleMesh quad = make_quad({-size.x / 2, -size.y / 2, 0}, {size.x, 0, 0}, {0, size.y, 0});
    const int material = writer.add_material(
        name,
        {.color = {0, 0, 0, 1}, .metallic = 0, .emissive = color, .emissive_strength = strength});
    const GltfPrimitive primitive = writer.add_primitive(quad, material);
    // The quad faces +z; look_rotation turns -z towards its second argument.
    writer.add_node({.name = name,
                     .translation = center,
                     .rotation = look_rotation(target, center),
                     .mesh = writer.add_mesh(name, {&primitive, 1})});
}

}  // namespace

Result<void> write_spheres(const std::filesystem::path& folder) {
    GltfWriter writer;
    add_spheres(writer);
    TriangleMesh backdrop = make_backdrop();
    const int paper = writer.add_material(
        "paper", {.color = {0.13f, 0.135f, 0.15f, 1}, .metallic = 0, .roughness = 0.9f});
    writer.add_object("backdrop", backdrop, paper);
    const glm::vec3 middle(0, 2.5f, 0);
    add_lamp(writer, "key", {-9, 8, 5}, middle, {4, 4}, {1, 0.93f, 0.82f}, 30);
    add_lamp(writer, "fill", {8, 5, 8}, middle, {2, 5}, {0.75f, 0.87f, 1}, 8);
    add_lamp(writer, "top", {0, 9.5f, 0}, middle, {9, 1}, {1, 1, 1}, 6);

    const glm::vec3 eye(0, 3.0f, 13);
    writer.add_node({.name = "camera",
                     .translation = eye,
                     .rotation = look_rotation(eye, {0, 2.5f, 0}),
                     .camera = writer.add_camera("camera", 0.42f, 16.0f / 9, 0.1f)});
    return write_scene(folder, "spheres", writer,
                       {{"size", "1280x720"}, {"spp", "256"}, {"env-intensity", "0.25"}});
}

}  // namespace hm
