#include "session/aovs.h"

#include <algorithm>

#include "scene/light_groups.h"

namespace hm {
namespace {

AovSelection select_aovs(const RenderSettings& settings) {
    AovSelection selection;
    for (const AovInfo& info : all_aovs()) {
        const auto& chosen = settings.layers.aovs;
        const bool wanted = std::find(chosen.begin(), chosen.end(), info.aov) != chosen.end();
        const bool guides = info.aov == Aov::albedo || info.aov == Aov::normal;
        if (wanted || (settings.denoise.enabled && guides) ||
            (info.aov == Aov::light_groups && settings.layers.light_groups))
            selection.aovs.push_back(info.aov);
    }
    selection.sample_variance = settings.path.sampler == kSamplerIndependent;
    return selection;
}

}  // namespace

Result<std::optional<PoseRecord>> record_next_pose(const RenderSettings& settings, Scene& scene,
                                                   const std::optional<PoseTime>& pose) {
    if (!pose || !select_aovs(settings).has(Aov::motion)) return std::nullopt;
    HM_TRY(pose_scene(
        scene, PoseTime{pose->animations, pose->seconds + 1.0 / double(settings.animation.fps)}));
    return record_pose(scene);
}

AovSetup prepare_aovs(const RenderSettings& settings, const Scene& scene, FlatScene& flat,
                      const std::optional<PoseRecord>& next_pose) {
    AovSetup setup{select_aovs(settings), scene.origin, {}};
    if (setup.selection.has(Aov::light_groups)) {
        LightGroups groups = find_light_groups(scene, flat);
        setup.selection.light_groups = std::move(groups.names);
        flat.aovs.source_groups = std::move(groups.source_groups);
    }
    if (setup.selection.wants_ids()) setup.names = name_surfaces(scene, flat);
    if (next_pose) set_next_pose(flat, scene, *next_pose);
    return setup;
}

}  // namespace hm
