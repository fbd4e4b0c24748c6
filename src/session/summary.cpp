#include "session/summary.h"

#include <utility>

#include "film/variance.h"

namespace hm {

double RenderSummary::removed_share() const {
    const double all = removed_luminance + mean_luminance;
    return all > 0 ? removed_luminance / all : 0;
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
