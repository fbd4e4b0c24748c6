#include "support/pictures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cpu/render.h"
#include "scene/camera.h"
#include "scene/light_groups.h"
#include "scene/motion.h"
#include "scene/render_params.h"
#include "scene/tangents.h"
#include "shading/tables/tables.h"
#include "support/statistics.h"

namespace hm::test {
namespace {

Scene with_tangents(Scene scene) {
    prepare_tangents(scene);
    return scene;
}

std::unique_ptr<Renderer> make_cpu_renderer(const FlatScene& flat, unsigned threads) {
    return std::make_unique<CpuRenderer>(flat, threads);
}

}  // namespace

Backend& backend() {
    static Backend chosen{make_cpu_renderer, true};
    return chosen;
}

vec3 Picture::mean() const {
    glm::dvec3 sum(0);
    for (const vec3& p : pixels)
        sum += glm::dvec3(p);
    return vec3(sum / double(pixels.size()));
}

Studio::Studio(Scene scene, EnvironmentMap environment, LightChoice choice, unsigned threads)
    : scene_(with_tangents(std::move(scene))),
      flat_(flatten_quietly(scene_, std::move(environment), choice)),
      renderer_(backend().make(flat_, threads)) {}

void Studio::draw(const CameraData& camera, const CameraData& next_camera, const Shot& shot,
                  Film& film) {
    const RenderParams params = make_params(flat_, shot.width, shot.height,
                                            {.seed = shot.seed,
                                             .sampler = shot.sampler,
                                             .bounces = shot.bounces,
                                             .clamp = shot.clamp,
                                             .strategy = shot.strategy,
                                             .energy_compensation = shot.energy_compensation,
                                             .background = shot.background,
                                             .filter = PixelFilter::box});
    static const std::array<float, 257> box = make_filter_table(PixelFilter::box);
    RenderCounters counters;
    EXPECT_TRUE(renderer_->begin({camera, params, box, next_camera}, film));
    EXPECT_TRUE(renderer_->render(shot.first_sample, shot.first_sample + shot.samples, counters,
                                  std::atomic<bool>(false)));
    EXPECT_TRUE(renderer_->sync());
    EXPECT_EQ(counters.non_finite.load(), 0u);
}

std::vector<PixelSum> Studio::render_sums(const CameraData& camera, const Shot& shot,
                                          PixelRect crop) {
    Film film(crop);
    draw(camera, camera, shot, film);
    return film.sums;
}

Film Studio::render_film(const CameraData& camera, const Shot& shot, const std::vector<Aov>& aovs,
                         const CameraData& next_camera) {
    AovSelection selection;
    selection.aovs = aovs;
    selection.sample_variance = shot.sampler == kSamplerIndependent;
    if (selection.has(Aov::light_groups)) {
        LightGroups groups = find_light_groups(scene_, flat_);
        selection.light_groups = groups.names;
        flat_.aovs.source_groups = groups.source_groups;
    }
    Film film({0, 0, shot.width, shot.height}, selection);
    draw(camera, next_camera.half_width > 0 ? next_camera : camera, shot, film);
    return film;
}

void Studio::set_next(const Scene& next) {
    PoseRecord record = record_pose(next);
    set_next_pose(flat_, scene_, record);
}

Picture Studio::render(const CameraData& camera, const Shot& shot) {
    Picture picture{shot.width, shot.height, {}, {}};
    for (const PixelSum& s : render_sums(camera, shot, {0, 0, shot.width, shot.height})) {
        picture.pixels.push_back(s.radiance / s.weight);
        picture.alpha.push_back(s.alpha / s.weight);
    }
    return picture;
}

CameraData flat_camera(vec3 point, vec3 from, float half) {
    const vec3 back = normalize(from);
    const vec3 up = std::abs(back.y) < 0.9f ? vec3(0, 1, 0) : vec3(0, 0, -1);
    CameraData camera = camera_look_at(point + back, point, up, 1, 1);
    camera.kind = kCameraOrthographic;
    camera.half_width = camera.half_height = half;
    return camera;
}

CameraData point_camera(vec3 point, vec3 from) {
    return flat_camera(point, from, 1e-6f);
}

Estimate estimate(const std::vector<vec3>& replicates) {
    glm::dvec3 sum(0), squares(0);
    for (const vec3& r : replicates)
        sum += glm::dvec3(r);
    const double n = double(replicates.size());
    const glm::dvec3 mean = sum / n;
    for (const vec3& r : replicates)
        squares += (glm::dvec3(r) - mean) * (glm::dvec3(r) - mean);
    return {vec3(mean), vec3(glm::sqrt(squares / (n - 1) / n))};
}

std::vector<Picture> replicate(Studio& studio, const CameraData& camera, Shot shot, int count,
                               uint first_seed) {
    std::vector<Picture> pictures;
    for (int i = 0; i < count; ++i) {
        shot.seed = first_seed + uint(i);
        pictures.push_back(studio.render(camera, shot));
    }
    return pictures;
}

void expect_radiance(Studio& studio, const CameraData& camera, Shot shot, vec3 exact,
                     double precision, int replicates) {
    std::vector<vec3> means;
    for (const Picture& p : replicate(studio, camera, shot, replicates, shot.seed))
        means.push_back(p.mean());
    Estimate e = estimate(means);
    for (std::size_t k = 0; k < 3; ++k) {
        const double off = std::abs(double(e.mean[k]) - double(exact[k]));
        const double error = double(e.error[k]);
        EXPECT_LE(error, precision * double(exact[k]) + 1e-9) << "too noisy to tell";
        // Rounding: a relative error of 2e-5, and an absolute one of 1e-7 for black.
        const double excess = std::max(0.0, off - 2e-5 * double(exact[k]) - 1e-7);
        if (excess == 0) continue;
        const double p = error > 0 ? student_tail(excess / error, replicates - 1) : 0.0;
        EXPECT_GT(p, single_level())
            << "channel " << k << ": " << e.mean[k] << " +- " << error << ", exact " << exact[k];
    }
}

namespace {

// Welch's t-test of two sets of replicates, with the smaller of their degrees of freedom.
double welch_p(const std::vector<vec3>& a, const std::vector<vec3>& b, std::size_t channel) {
    const Estimate ea = estimate(a), eb = estimate(b);
    const double off = std::abs(double(ea.mean[channel]) - double(eb.mean[channel]));
    const double error = std::hypot(double(ea.error[channel]), double(eb.error[channel]));
    const double excess =
        std::max(0.0, off - 1e-5 * double(ea.mean[channel] + eb.mean[channel]) - 1e-7);
    if (excess == 0) return 1;
    return error > 0 ? student_tail(excess / error, int(std::min(a.size(), b.size())) - 1) : 0;
}

}  // namespace

void expect_same_pictures(const std::vector<Picture>& a, const std::vector<Picture>& b,
                          const std::string& what) {
    const std::size_t count = a[0].pixels.size();
    const double level = sidak_level(single_level() * 100, int(count) * 3);
    int failed = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<vec3> pa, pb;
        for (const Picture& p : a)
            pa.push_back(p.pixels[i]);
        for (const Picture& p : b)
            pb.push_back(p.pixels[i]);
        for (std::size_t k = 0; k < 3; ++k)
            failed += welch_p(pa, pb, k) > level ? 0 : 1;
    }
    EXPECT_EQ(failed, 0) << what << ": pixels that differ, of " << count;
    std::vector<vec3> ma, mb;
    for (const Picture& p : a)
        ma.push_back(p.mean());
    for (const Picture& p : b)
        mb.push_back(p.mean());
    const Estimate ea = estimate(ma), eb = estimate(mb);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GT(welch_p(ma, mb, k), single_level() * 100)
            << what << ", channel " << k << ": means " << ea.mean[k] << " +- " << ea.error[k]
            << " and " << eb.mean[k] << " +- " << eb.error[k];
        EXPECT_LT(ea.error[k] + eb.error[k], 0.05f * (ea.mean[k] + eb.mean[k]))
            << what << ": too noisy to tell";
    }
}

}  // namespace hm::test
