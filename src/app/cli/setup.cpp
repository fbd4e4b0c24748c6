#include "app/cli/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/files.h"
#include "base/hash.h"
#include "image/read.h"
#include "scene/camera.h"

namespace hm::cli {
namespace {

constexpr float kDefaultFov = 45;

float radians_of(float degrees) {
    return degrees * std::numbers::pi_v<float> / 180.0f;
}

float default_filter_width(PixelFilter filter) {
    return filter == PixelFilter::box ? 1.0f : filter == PixelFilter::gaussian ? 2.0f : 3.0f;
}

// Nodes that carry a camera, in the file's order: what --camera counts.
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
    return fail(ErrorKind::invalid_argument, scene.file, "",
                fmt::format("--camera: there is no camera \"{}\"; the file has {}", wanted,
                            known.empty() ? "none" : known));
}

Result<CameraChoice> file_camera(const ViewOptions& view, const Scene& scene,
                                 const std::vector<std::size_t>& nodes,
                                 const std::vector<glm::mat4>& world, const Bounds& bounds,
                                 float aspect) {
    std::size_t chosen = 0;
    if (!view.camera.empty()) {
        HM_TRY_ASSIGN(chosen, find_camera(view.camera, scene, nodes));
    }
    const std::size_t node = nodes[chosen];
    Camera camera = camera_of(scene, node);
    if (view.fov && !camera.perspective)
        return fail(ErrorKind::invalid_argument, scene.file, "",
                    "--fov: the chosen camera is orthographic and has no field of view");
    if (view.fov) camera.yfov = radians_of(*view.fov);
    CameraChoice choice{camera_from_node(camera, world[node], aspect),
                        fmt::format("camera {}", chosen)};
    if (!name_of(scene, node).empty()) choice.name += fmt::format(" ({})", name_of(scene, node));
    const float middle = dot(bounds.center() - choice.data.origin, choice.data.forward);
    if (!bounds.empty() && middle > 0) choice.data.focus_distance = middle;
    return choice;
}

}  // namespace

Result<EnvironmentChoice> choose_environment(const RenderOptions& options, const Scene& scene) {
    const bool has_lights =
        options.punctual && std::any_of(scene.nodes.begin(), scene.nodes.end(),
                                        [](const Node& node) { return node.light != kUnset; });
    if (options.env == "none" || (options.env.empty() && has_lights))
        return EnvironmentChoice{{}, "none", ""};
    if (options.env.empty())
        return EnvironmentChoice{
            make_environment(default_environment(), options.env_rotation, options.env_intensity),
            "default", ""};
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(options.env));
    HM_TRY_ASSIGN(const Image image, read_environment_image(bytes, options.env));
    Hasher hash;
    hash.add(bytes);
    return EnvironmentChoice{make_environment(image, options.env_rotation, options.env_intensity),
                             options.env, hash.text()};
}

Result<CameraChoice> choose_camera(const ViewOptions& view, const Scene& scene,
                                   const std::vector<glm::mat4>& world, const Bounds& bounds,
                                   float aspect) {
    const std::vector<std::size_t> nodes = camera_nodes(scene);
    const float fov = radians_of(view.fov.value_or(kDefaultFov));
    CameraChoice choice;
    if (view.eye) {
        const vec3 middle = bounds.empty() ? vec3(0) : bounds.center();
        const vec3 target = view.target.value_or(middle);
        if (target == *view.eye)
            return fail(ErrorKind::invalid_argument, "", "",
                        "--eye: is the scene's middle; give a --target");
        choice = {camera_look_at(*view.eye, target, view.up.value_or(vec3(0, 1, 0)), fov, aspect),
                  "look-at"};
    } else if (!nodes.empty() || !view.camera.empty()) {
        HM_TRY_ASSIGN(choice, file_camera(view, scene, nodes, world, bounds, aspect));
    } else {
        choice = {camera_framing(bounds, fov, aspect), "framing"};
    }
    choice.data.lens_radius = view.aperture;
    if (view.focus) choice.data.focus_distance = *view.focus;
    return choice;
}

Result<CameraChoice> choose_camera(const ViewOptions& view, const Scene& scene,
                                   const Bounds& bounds, float aspect) {
    return choose_camera(view, scene, world_transforms(scene), bounds, aspect);
}

std::string view_flags(const CameraData& c) {
    if (c.kind != kCameraPerspective) return "";
    const auto triple = [](vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    const vec3 target = c.origin + c.forward * c.focus_distance;
    const float fov = 2.0f * std::atan(c.half_height) * 180.0f / std::numbers::pi_v<float>;
    std::string flags = fmt::format("--eye {} --target {} --up {} --fov {}", triple(c.origin),
                                    triple(target), triple(c.up), fov);
    if (c.lens_radius > 0)
        flags += fmt::format(" --aperture {} --focus {}", c.lens_radius, c.focus_distance);
    return flags;
}

RenderParams make_params(const RenderOptions& options, const FlatScene& scene) {
    RenderParams p{};
    p.width = options.width;
    p.height = options.height;
    p.seed = options.seed;
    p.sampler_kind = options.sampler;
    p.max_bounces = options.bounces;
    p.max_radiance = options.clamp;
    p.strategy = options.strategy;
    p.energy_compensation = options.energy_compensation ? 1 : 0;
    p.diffuse_kind = options.diffuse;
    p.background = options.background;
    p.background_color = options.background_color;
    p.filter_width = options.filter_width.value_or(default_filter_width(options.filter));
    set_light_ranges(scene, p);
    return p;
}

}  // namespace hm::cli
