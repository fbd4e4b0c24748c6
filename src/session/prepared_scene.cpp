#include "session/prepared_scene.h"

namespace hm {

Result<std::unique_ptr<PreparedScene>> prepare_scene(const std::filesystem::path& file,
                                                     const LoadOptions& load,
                                                     const RenderSettings& settings,
                                                     Diagnostics& diagnostics) {
    auto prepared = std::make_unique<PreparedScene>();
    HM_TRY_ASSIGN(prepared->scene, load_gltf(file, diagnostics, load));
    HM_TRY_ASSIGN(EnvironmentChoice environment,
                  choose_environment(settings.light, prepared->scene, diagnostics));
    HM_TRY_ASSIGN(prepared->setup,
                  set_up_picture(settings, prepared->scene, environment, diagnostics));
    return prepared;
}

}  // namespace hm
