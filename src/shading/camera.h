// Camera rays: pinhole, orthographic and thin lens.
#ifndef HM_SHADING_CAMERA_H
#define HM_SHADING_CAMERA_H

#include "shading/structs.h"
#include "shading/warp.h"

HM_NAMESPACE_BEGIN

struct CameraRay {
    vec3 origin;
    vec3 direction;  // unit
};

// film in [0, 1]^2, (0, 0) the upper left corner; lens_u, lens_v uniform numbers.
HM_FN void make_camera_ray(HM_IN(CameraData) camera, vec2 film, float lens_u, float lens_v,
                           HM_OUT(CameraRay) ray) {
    float x = (2.0f * film.x - 1.0f) * camera.half_width;
    float y = (1.0f - 2.0f * film.y) * camera.half_height;
    vec3 across = camera.right * x + camera.up * y;
    ray.origin = camera.origin;
    ray.direction = camera.forward;
    if (camera.kind == kCameraOrthographic) {
        ray.origin = camera.origin + across;
    } else {
        ray.direction = camera.forward + across;
    }
    if (camera.lens_radius > 0.0f) {
        // All rays of a film point meet where its central ray crosses the plane of focus.
        vec3 focus = ray.origin + ray.direction * camera.focus_distance;
        vec2 lens = camera.lens_radius * sample_disk(lens_u, lens_v);
        ray.origin = ray.origin + camera.right * lens.x + camera.up * lens.y;
        ray.direction = focus - ray.origin;
    }
    ray.direction = normalize(ray.direction);
}

// Where the camera sees a point: film coordinates as above. False if it lies behind.
HM_FN bool project_point(HM_IN(CameraData) camera, vec3 point, HM_OUT(vec2) film) {
    vec3 to_point = point - camera.origin;
    float depth = camera.kind == kCameraOrthographic ? 1.0f : dot(to_point, camera.forward);
    film = vec2(0.5f);
    if (!(depth > 0.0f)) return false;
    film.x = 0.5f + 0.5f * dot(to_point, camera.right) / (depth * camera.half_width);
    film.y = 0.5f - 0.5f * dot(to_point, camera.up) / (depth * camera.half_height);
    return true;
}

HM_NAMESPACE_END

#endif
