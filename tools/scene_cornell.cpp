// The Cornell box as it was measured at Cornell University (room, blocks, lamp and camera in
// millimetres; reflectances and lamp as linear Rec.709). The lamp hangs a millimetre below the
// ceiling.
#include <array>
#include <cmath>

#include "scenes.h"

namespace hm {
namespace {

using Corners = std::array<glm::vec3, 4>;

// A flat quad of four measured corners, counter-clockwise seen from its front, in millimetres.
TriangleMesh make_measured_quad(const Corners& corners_mm) {
    TriangleMesh mesh;
    const glm::vec3 normal =
        glm::normalize(glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]));
    for (const glm::vec3& corner : corners_mm) {
        mesh.positions.push_back(corner * 1e-3f);
        mesh.normals.push_back(normal);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

// A block from its measured top, given counter-clockwise from above, down to the floor.
TriangleMesh make_block(const Corners& top_mm) {
    TriangleMesh mesh;
    append(mesh, make_measured_quad(top_mm), glm::mat4(1));
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3 a = top_mm[i], b = top_mm[(i + 1) % 4];
        const glm::vec3 a_floor(a.x, 0, a.z), b_floor(b.x, 0, b.z);
        append(mesh, make_measured_quad({a, a_floor, b_floor, b}), glm::mat4(1));
    }
    return mesh;
}

int add_diffuse(GltfWriter& writer, const char* name, glm::vec3 color) {
    return writer.add_material(name, {.color = glm::vec4(color, 1), .metallic = 0});
}

}  // namespace

Result<void> write_cornell(const std::filesystem::path& folder) {
    GltfWriter writer;
    const int white = add_diffuse(writer, "white", {0.725f, 0.71f, 0.68f});
    const int red = add_diffuse(writer, "red", {0.63f, 0.065f, 0.05f});
    const int green = add_diffuse(writer, "green", {0.14f, 0.45f, 0.091f});
    const int lamp = writer.add_material("lamp", {.color = {0.78f, 0.78f, 0.78f, 1},
                                                  .metallic = 0,
                                                  .emissive = {1, 0.705882f, 0.235294f},
                                                  .emissive_strength = 17});

    const auto add = [&](const char* name, const Corners& corners, int material) {
        writer.add_object(name, make_measured_quad(corners), material);
    };
    add("floor", {{{552.8f, 0, 0}, {0, 0, 0}, {0, 0, 559.2f}, {549.6f, 0, 559.2f}}}, white);
    add("ceiling", {{{556, 548.8f, 0}, {556, 548.8f, 559.2f}, {0, 548.8f, 559.2f}, {0, 548.8f, 0}}},
        white);
    add("back wall",
        {{{549.6f, 0, 559.2f}, {0, 0, 559.2f}, {0, 548.8f, 559.2f}, {556, 548.8f, 559.2f}}}, white);
    add("right wall", {{{0, 0, 559.2f}, {0, 0, 0}, {0, 548.8f, 0}, {0, 548.8f, 559.2f}}}, green);
    add("left wall",
        {{{552.8f, 0, 0}, {549.6f, 0, 559.2f}, {556, 548.8f, 559.2f}, {556, 548.8f, 0}}}, red);
    add("lamp", {{{343, 547.8f, 227}, {343, 547.8f, 332}, {213, 547.8f, 332}, {213, 547.8f, 227}}},
        lamp);
    const Corners short_top = {{{130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114}}};
    const Corners tall_top = {{{423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406}}};
    writer.add_object("short block", make_block(short_top), white);
    writer.add_object("tall block", make_block(tall_top), white);

    // A 25 mm square film behind a 35 mm lens.
    const glm::vec3 eye(0.278f, 0.273f, -0.8f);
    writer.add_node(
        {.name = "camera",
         .translation = eye,
         .rotation = look_rotation(eye, eye + glm::vec3(0, 0, 1)),
         .camera = writer.add_camera("camera", 2 * std::atan(12.5f / 35.0f), 1, 0.01f)});
    return write_scene(
        folder, "cornell", writer,
        {{"size", "1024x1024"}, {"spp", "512"}, {"env", "none"}, {"exposure", "1.2"}});
}

}  // namespace hm
