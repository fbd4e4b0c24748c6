// Renders small scenes with the real renderer and compares images statistically.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "film/renderer.h"
#include "scene/flatten.h"
#include "support/scenes.h"

namespace hm::test {

struct Shot {
    uint width = 8, height = 8;
    uint samples = 64;
    uint first_sample = 0;
    uint bounces = 1;  // 0: no limit
    uint seed = 1;
    uint strategy = kStrategyMis;
    uint sampler = kSamplerIndependent;
    bool energy_compensation = true;
    uint background = kBackgroundEnvironment;
    float clamp = 0;
};

struct Picture {
    uint width, height;
    std::vector<vec3> pixels;  // mean over the samples
    std::vector<float> alpha;
    vec3 mean() const;
};

// What studios render with: the CPU, unless a test program replaces it.
struct Backend {
    std::unique_ptr<Renderer> (*make)(const FlatScene&, unsigned threads);
    bool thorough;  // false where scenes are slow to make: sweeps take fewer steps
};
Backend& backend();

// A scene ready for rendering. Not copyable: it contains pointers into itself.
class Studio {
  public:
    explicit Studio(Scene scene, EnvironmentMap environment = {}, LightChoice choice = {},
                    unsigned threads = 1);
    Studio(const Studio&) = delete;

    Picture render(const CameraData& camera, const Shot& shot);
    std::vector<PixelSum> render_sums(const CameraData& camera, const Shot& shot, PixelRect crop);
    // Renders with AOVs; light groups are determined by find_light_groups.
    Film render_film(const CameraData& camera, const Shot& shot, const std::vector<Aov>& aovs,
                     const CameraData& next_camera = {});
    // Sets the next frame for motion vectors: `next` is the same scene in another pose.
    void set_next(const Scene& next);
    const FlatScene& flat() const { return flat_; }
    const Scene& scene() const { return scene_; }

  private:
    void draw(const CameraData& camera, const CameraData& next_camera, const Shot& shot,
              Film& film);

    Scene scene_;
    FlatScene flat_;
    std::unique_ptr<Renderer> renderer_;
};

// A camera whose pixels all see the same point, from the direction `from`.
CameraData point_camera(vec3 point, vec3 from);
// An orthographic camera of half extent `half` around the point, looking along -from.
CameraData flat_camera(vec3 point, vec3 from, float half);

// Mean of independently seeded replicates, with its standard error.
struct Estimate {
    vec3 mean{0};
    vec3 error{0};  // standard error of the mean
};
Estimate estimate(const std::vector<vec3>& replicates);

// Expects that the mean over all pixels of independently seeded images agrees with an exact value:
// within the suite's significance level, and with a relative measurement error of `precision`.
void expect_radiance(Studio& studio, const CameraData& camera, Shot shot, vec3 exact,
                     double precision = 0.01, int replicates = 16);

// Expects that two rendering methods agree: in each pixel, and in the mean over all pixels.
void expect_same_pictures(const std::vector<Picture>& a, const std::vector<Picture>& b,
                          const std::string& what);
std::vector<Picture> replicate(Studio& studio, const CameraData& camera, Shot shot, int count,
                               uint first_seed);

}  // namespace hm::test
