#include "scene/camera.h"

#include <algorithm>
#include <cmath>

namespace hm {
namespace {

vec3 unit_or(vec3 v, vec3 fallback) {
    float squared = dot(v, v);
    return squared > kLeastSquaredLength ? v / std::sqrt(squared) : fallback;
}

}  // namespace

CameraData camera_from_node(const Camera& camera, const glm::mat4& world, float aspect) {
    CameraData c{};
    c.origin = vec3(world[3]);
    c.right = unit_or(vec3(world[0]), vec3(1, 0, 0));
    c.up = unit_or(vec3(world[1]), vec3(0, 1, 0));
    c.forward = unit_or(-vec3(world[2]), vec3(0, 0, -1));
    c.kind = camera.perspective ? kCameraPerspective : kCameraOrthographic;
    c.half_height = camera.perspective ? std::tan(0.5f * camera.yfov) : camera.ymag;
    c.half_width = c.half_height * aspect;
    c.focus_distance = 1;
    return c;
}

CameraData camera_look_at(vec3 eye, vec3 target, vec3 up, float yfov, float aspect) {
    CameraData c{};
    c.origin = eye;
    c.forward = unit_or(target - eye, vec3(0, 0, -1));
    vec3 side = cross(c.forward, up);
    if (dot(side, side) < 1e-12f * dot(up, up))
        side = cross(c.forward, std::abs(c.forward.x) < 0.9f ? vec3(1, 0, 0) : vec3(0, 0, 1));
    c.right = normalize(side);
    c.up = cross(c.right, c.forward);
    c.half_height = std::tan(0.5f * yfov);
    c.half_width = c.half_height * aspect;
    c.kind = kCameraPerspective;
    c.focus_distance = std::max(length(target - eye), 1e-6f);
    return c;
}

CameraData camera_framing(const Bounds& bounds, float yfov, float aspect) {
    if (bounds.empty()) return camera_look_at(vec3(0, 0, 1), vec3(0), vec3(0, 1, 0), yfov, aspect);
    vec3 back = normalize(vec3(0.5f, 0.35f, 1.0f));
    CameraData c =
        camera_look_at(bounds.center() + back, bounds.center(), vec3(0, 1, 0), yfov, aspect);
    // Far enough for all eight corners to lie inside the frustum, with a margin.
    float distance = 0;
    for (int i = 0; i < 8; ++i) {
        vec3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                    (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                    (i & 4) != 0 ? bounds.high.z : bounds.low.z);
        vec3 p = corner - bounds.center();
        float across = std::max(std::abs(dot(p, c.right)) / c.half_width,
                                std::abs(dot(p, c.up)) / c.half_height);
        distance = std::max(distance, across + dot(p, back));
    }
    distance = std::max(distance * 1.05f, 1e-4f);
    c.origin = bounds.center() + back * distance;
    c.focus_distance = distance;
    return c;
}

}  // namespace hm
