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

HM_NAMESPACE_END

#endif
