#include "film/renderer.h"

namespace hm {

AovParams aov_params(const AovSelection& selection, const RenderJob& job, bool moves) {
    AovParams params{};
    params.light_groups = std::uint32_t(selection.light_groups.size());
    const bool replicates = selection.has(Aov::variance) && !selection.sample_variance;
    params.replicates = replicates ? kReplicates : 0;
    params.moves = moves ? 1 : 0;
    params.next_camera = job.next_camera;
    return params;
}

}  // namespace hm
