#include "session/camera_choice.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

#include "scene/camera.h"

namespace hm {
namespace {

constexpr float kDefaultFov = 45;

float radians_of(float degrees) {
    return degrees * std::numbers::pi_v<float> / 180.0f;
}

// Nodes that carry a camera, in the file's order, which is that of camera indices.
std::vector<std::size_t> camera_nodes(const Scene& scene) {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (scene.nodes[i].camera != kUnset) nodes.push_back(i);
    return nodes;
}

const Camera& camera_of(const Scene& scene, std::size_t node) {
    return scene.cameras[std::size_t(scene.nodes[node].camera)];
}

const std::string& name_of(const Scene& scene, std::size_t node) {
    const std::string& name = scene.nodes[node].name;
    return name.empty() ? camera_of(scene, node).name : name;
}

// In the file's coordinates, with the digits of a float where that is what they are.
std::string coordinates_text(vec3 v, const glm::dvec3& origin) {
    const auto text = [&](int axis) {
        return origin[axis] == 0 ? fmt::format("{}", v[axis])
                                 : fmt::format("{}", origin[axis] + double(v[axis]));
    };
    return fmt::format("{},{},{}", text(0), text(1), text(2));
}

// Position within `nodes`; a name wins over an index.
Result<std::size_t> find_camera(const std::string& wanted, const Scene& scene,
                                const std::vector<std::size_t>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (scene.nodes[nodes[i]].name == wanted || camera_of(scene, nodes[i]).name == wanted)
            return i;
    std::size_t index = 0;
    const char* end = wanted.data() + wanted.size();
    const auto [stopped, error] = std::from_chars(wanted.data(), end, index);
    if (error == std::errc() && stopped == end && index < nodes.size()) return index;
    std::string known;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        known += fmt::format("{}{} \"{}\"", i == 0 ? "" : ", ", i, name_of(scene, nodes[i]));
    return fail_setting("camera",
                        fmt::format("there is no camera \"{}\"; the file has {}", wanted,
                                    known.empty() ? "none" : known),
                        scene.file);
}

// Whether the first one, which is the default, can be used.
bool has_usable_camera(const Scene& scene, const std::vector<std::size_t>& nodes) {
    return !nodes.empty() && !camera_of(scene, nodes[0]).fault;
}

Result<CameraChoice> file_camera(const ViewSettings& view, const Scene& scene,
                                 const std::vector<std::size_t>& nodes,
                                 const std::vector<glm::dmat4>& world, const Bounds& bounds,
                                 float aspect) {
    std::size_t chosen = 0;
    if (!view.camera.empty()) {
        HM_TRY_ASSIGN(chosen, find_camera(view.camera, scene, nodes));
    }
    const std::size_t node = nodes[chosen];
    Camera camera = camera_of(scene, node);
    if (camera.fault) return tl::unexpected(*camera.fault);
    if (view.fov && !camera.perspective)
        return fail_setting("fov", "the chosen camera is orthographic and has no field of view",
                            scene.file);
    if (view.fov) camera.yfov = radians_of(*view.fov);
    CameraChoice choice{camera_from_node(camera, glm::mat4(world[node]), aspect),
                        fmt::format("camera {}", chosen)};
    if (!name_of(scene, node).empty()) choice.name += fmt::format(" ({})", name_of(scene, node));
    const float middle = dot(bounds.center() - choice.data.origin, choice.data.forward);
    if (!bounds.empty() && middle > 0) choice.data.focus_distance = middle;
    return choice;
}

}  // namespace

Result<CameraChoice> choose_camera(const ViewSettings& view, const Scene& scene,
                                   const std::vector<glm::dmat4>& world, const Bounds& bounds,
                                   float aspect) {
    const std::vector<std::size_t> nodes = camera_nodes(scene);
    const float fov = radians_of(view.fov.value_or(kDefaultFov));
    CameraChoice choice;
    if (view.eye) {
        const vec3 eye(*view.eye - scene.origin);
        const vec3 middle = bounds.empty() ? vec3(0) : bounds.center();
        const vec3 target = view.target ? vec3(*view.target - scene.origin) : middle;
        if (target == eye)
            return fail_setting("eye", view.target ? "is too close to the target"
                                                   : "is the centre of the scene, so a target is "
                                                     "needed");
        choice = {camera_look_at(eye, target, view.up.value_or(vec3(0, 1, 0)), fov, aspect),
                  "look-at"};
    } else if (view.camera.empty() ? has_usable_camera(scene, nodes) : view.camera != kNoCamera) {
        HM_TRY_ASSIGN(choice, file_camera(view, scene, nodes, world, bounds, aspect));
    } else {
        choice = {camera_framing(bounds, fov, aspect), "framing"};
    }
    choice.data.lens_radius = view.aperture;
    if (view.focus) choice.data.focus_distance = *view.focus;
    return choice;
}

Result<CameraChoice> choose_camera(const ViewSettings& view, const Scene& scene,
                                   const Bounds& bounds, float aspect) {
    return choose_camera(view, scene, world_transforms(scene), bounds, aspect);
}

NamedValues view_of(const CameraData& c, const glm::dvec3& origin) {
    if (c.kind != kCameraPerspective) return {};
    const auto triple = [](vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    const auto point = [&](vec3 v) { return coordinates_text(v, origin); };
    const vec3 target = c.origin + c.forward * c.focus_distance;
    const float fov = 2.0f * std::atan(c.half_height) * 180.0f / std::numbers::pi_v<float>;
    NamedValues view = {{"eye", point(c.origin)},
                        {"target", point(target)},
                        {"up", triple(c.up)},
                        {"fov", fmt::format("{}", fov)}};
    if (c.lens_radius > 0) {
        view.emplace_back("aperture", fmt::format("{}", c.lens_radius));
        view.emplace_back("focus", fmt::format("{}", c.focus_distance));
    }
    return view;
}

}  // namespace hm
