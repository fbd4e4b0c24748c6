#include "session/picture_setup.h"

#include <utility>

#include "scene/render_params.h"
#include "session/camera_choice.h"
#include "session/pose_choice.h"

namespace hm {
namespace {

Result<RenderJob> make_job(const RenderSettings& settings, const Scene& scene,
                           const FlatScene& flat, const CameraData& camera,
                           const std::optional<PoseRecord>& next_pose) {
    const FrameSettings& frame = settings.frame;
    RenderJob job{camera, make_params(flat, frame.width, frame.height, settings.path),
                  make_filter_table(settings.path.filter)};
    if (!next_pose) return job;
    HM_TRY_ASSIGN(const CameraChoice next, choose_camera(settings.view, scene, next_pose->world,
                                                         flat.bounds, frame.aspect()));
    job.next_camera = next.data;
    return job;
}

float light_scale(const LightSettings& light) {
    return light.units == LightUnits::blender ? 1 / 683.0f : 1.0f;
}

}  // namespace

Result<PictureSetup> set_up_picture(const RenderSettings& settings, Scene& scene,
                                    EnvironmentChoice& environment, Diagnostics& diagnostics) {
    PictureSetup setup;
    HM_TRY_ASSIGN(const auto pose, choose_pose(settings.animation, scene, diagnostics));
    HM_TRY_ASSIGN(const auto next_pose, record_next_pose(settings, scene, pose));
    if (pose) HM_TRY(pose_scene(scene, pose));
    setup.flat = flatten(scene, std::move(environment.map),
                         LightChoice{.punctual = settings.light.punctual,
                                     .punctual_scale = light_scale(settings.light)},
                         diagnostics);
    HM_TRY_ASSIGN(const CameraChoice camera,
                  choose_camera(settings.view, scene, setup.flat.bounds, settings.frame.aspect()));
    setup.aovs = prepare_aovs(settings, scene, setup.flat, next_pose);
    HM_TRY_ASSIGN(setup.job, make_job(settings, scene, setup.flat, camera.data, next_pose));
    setup.summary.environment = environment.name;
    setup.summary.camera = camera.name;
    setup.summary.view = view_of(camera.data, scene.origin);
    setup.summary.scene = scene_stats(scene, setup.flat);
    setup.summary.scene_hash = scene.hash;
    setup.summary.mixes_light_units = settings.light.units == LightUnits::gltf &&
                                      !setup.flat.lights.empty() && !setup.flat.emitters.empty() &&
                                      scene.generator.find("Blender") != scene.generator.npos;
    return setup;
}

}  // namespace hm
