#include "app/cli/prepared_scene.h"

#include <utility>

#include "app/cli/setup.h"
#include "gltf/load.h"

namespace hm::cli {

Result<std::unique_ptr<PreparedScene>> prepare_scene(const RenderOptions& options,
                                                     Diagnostics& diagnostics) {
    auto prepared = std::make_unique<PreparedScene>();
    HM_TRY_ASSIGN(prepared->scene, load_gltf(options.scene_file, diagnostics, options.load));
    HM_TRY_ASSIGN(EnvironmentChoice environment, choose_environment(options, prepared->scene));
    prepared->flat = flatten(prepared->scene, std::move(environment.map),
                             LightChoice{.punctual = options.punctual}, diagnostics);
    const float aspect = float(options.width) / float(options.height);
    HM_TRY_ASSIGN(const CameraChoice camera,
                  choose_camera(options.view, prepared->scene, prepared->flat.bounds, aspect));
    prepared->job = {camera.data, make_params(options, prepared->flat),
                     make_filter_table(options.filter)};
    return prepared;
}

}  // namespace hm::cli
