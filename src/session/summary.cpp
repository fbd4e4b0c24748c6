#include "session/summary.h"

#include <algorithm>
#include <utility>

#include "film/variance.h"

namespace hm {

double RenderSummary::removed_share() const {
    const double all = removed_luminance + mean_luminance;
    return all > 0 ? removed_luminance / all : 0;
}

// A path that hits a surface goes on with another ray, unless the surface scatters nothing.
bool RenderSummary::missed_everything() const {
    return samples > 0 && rays == samples && !scene.paths_may_end;
}

SceneStats scene_stats(const Scene& scene, const FlatScene& flat) {
    SceneStats s;
    s.meshes = scene.meshes.size();
    s.instances = flat.instances.size();
    s.materials = scene.materials.size();
    s.images = scene.images.size();
    for (const InstanceData& i : flat.instances)
        for (std::size_t g = i.first_geometry; g < flat.mesh_first_geometry[i.mesh + 1]; ++g)
            s.triangles += flat.geometries[g].triangle_count;
    s.punctual_lights = flat.lights.size();
    s.emissive_triangles = flat.emitters.size();
    s.paths_may_end = std::ranges::any_of(flat.materials, [](const MaterialData& m) {
        return (m.flags & kMaterialUnlit) != 0 || m.specular_weight == 0;
    });
    return s;
}

RenderSummary with_samples(RenderSummary summary, const Film& film, const RenderCounters& counters,
                           double seconds, const std::string& devices) {
    summary.renderer.device = devices;
    summary.times.render = seconds;
    summary.samples = counters.samples.load();
    summary.rays = counters.rays.load();
    summary.non_finite = counters.non_finite.load();
    summary.samples_per_pixel = film.mean_samples();
    summary.removed_luminance = film.removed_luminance();
    summary.mean_luminance = film.mean_luminance();
    summary.estimated_error = estimated_error(film);
    return summary;
}

}  // namespace hm
