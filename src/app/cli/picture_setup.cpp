#include "app/cli/picture_setup.h"

#include <utility>

#include "app/cli/frames.h"

namespace hm::cli {
namespace {

float aspect_of(const RenderOptions& options) {
    return float(options.width) / float(options.height);
}

Result<RenderJob> make_job(const RenderOptions& options, const Scene& scene, const FlatScene& flat,
                           const CameraData& camera, const std::optional<PoseRecord>& next_pose) {
    RenderJob job{camera, make_params(options, flat), make_filter_table(options.filter)};
    if (!next_pose) return job;
    HM_TRY_ASSIGN(const CameraChoice next, choose_camera(options.view, scene, next_pose->world,
                                                         flat.bounds, aspect_of(options)));
    job.next_camera = next.data;
    return job;
}

}  // namespace

Result<PictureSetup> set_up_picture(const RenderOptions& options, Scene& scene,
                                    EnvironmentChoice& environment, Diagnostics& diagnostics) {
    PictureSetup setup;
    HM_TRY_ASSIGN(const auto pose, choose_pose(options, scene, diagnostics));
    HM_TRY_ASSIGN(const auto next_pose, record_next_pose(options, scene, pose));
    if (pose) HM_TRY(pose_scene(scene, pose));
    setup.flat = flatten(scene, std::move(environment.map),
                         LightChoice{.punctual = options.punctual}, diagnostics);
    HM_TRY_ASSIGN(const CameraChoice camera,
                  choose_camera(options.view, scene, setup.flat.bounds, aspect_of(options)));
    setup.aovs = prepare_aovs(options, scene, setup.flat, next_pose);
    HM_TRY_ASSIGN(setup.job, make_job(options, scene, setup.flat, camera.data, next_pose));
    setup.summary.environment = environment.name;
    setup.summary.camera = camera.name;
    setup.summary.view = view_flags(camera.data);
    setup.summary.scene = scene_stats(scene, setup.flat);
    setup.summary.scene_hash = scene.hash;
    return setup;
}

}  // namespace hm::cli
