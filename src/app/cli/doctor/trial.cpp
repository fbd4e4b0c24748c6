#include "app/cli/doctor/trial.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "app/cli/demo.h"
#include "base/check.h"
#include "base/clock.h"
#include "session/prepared_scene.h"
#include "shading/color.h"
#include "shading/math.h"

namespace hm::cli {
namespace {

constexpr double kMeanTolerance = 1e-3, kStandardErrors = 4;
constexpr double kCloseTolerance = 1e-2, kShareClose = 0.99;

vec3 radiance_of(const PixelSum& sum) {
    return sum.weight > 0 ? sum.radiance / sum.weight : vec3(0);
}

bool is_close(vec3 a, vec3 b) {
    for (int c = 0; c < 3; ++c) {
        const double x = double(a[c]), y = double(b[c]);
        // Negated, so that NaN is not close.
        if (!(std::abs(x - y) <= kCloseTolerance * std::max(std::abs(x), std::abs(y))))
            return false;
    }
    return true;
}

Result<std::unique_ptr<PreparedScene>> load_trial_scene() {
    HM_TRY_ASSIGN(const Demo demo, find_demo("cornell"));
    RenderSettings settings;
    settings.light.environment = EnvironmentKind::none;
    settings.frame.width = settings.frame.height = kTrialSize;
    Diagnostics diagnostics;
    return prepare_scene(demo.scene, {}, settings, diagnostics);
}

Result<void> draw(const Contender& contender, const PreparedScene& scene, Film& film,
                  Trial& trial) {
    Clock::time_point start = Clock::now();
    HM_TRY_ASSIGN(const std::unique_ptr<RenderDevice> device, contender.open());
    HM_TRY_ASSIGN(const std::unique_ptr<Renderer> renderer, device->load(scene.setup.flat));
    HM_TRY(renderer->begin(scene.setup.job, film));
    trial.prepare_seconds = seconds_since(start);
    RenderCounters counters;
    const std::atomic<bool> cancel{false};
    start = Clock::now();
    HM_TRY(renderer->render(0, kTrialSamples, counters, cancel));
    HM_TRY(renderer->sync());
    trial.render_seconds = seconds_since(start);
    trial.rays = counters.rays.load();
    return {};
}

}  // namespace

bool Parity::holds() const {
    return (std::abs(mean_difference) <= kMeanTolerance ||
            std::abs(mean_difference) <= kStandardErrors * standard_error) &&
           share_close >= kShareClose;
}

Parity compare_films(const Film& film, const Film& reference) {
    HM_CHECK(film.sums.size() == reference.sums.size() && !film.sums.empty(), "{} and {} pixels",
             film.sums.size(), reference.sums.size());
    const double count = double(film.sums.size());
    double sum = 0, squares = 0, mean = 0, close = 0;
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        const vec3 a = radiance_of(film.sums[i]), b = radiance_of(reference.sums[i]);
        const double difference = double(luminance(a)) - double(luminance(b));
        sum += difference;
        squares += difference * difference;
        mean += double(luminance(b)) / count;
        close += is_close(a, b) ? 1 : 0;
    }
    const double variance = std::max(0.0, squares / count - sum / count * sum / count);
    return {sum / count / mean, std::sqrt(variance / count) / mean, close / count};
}

Result<std::vector<Trial>> run_trials(const std::vector<Contender>& contenders,
                                      const std::function<void(std::string_view)>& begun) {
    HM_TRY_ASSIGN(const std::unique_ptr<PreparedScene> scene, load_trial_scene());
    const PixelRect all{0, 0, kTrialSize, kTrialSize};
    std::optional<Film> reference;
    std::vector<Trial> trials;
    for (const Contender& contender : contenders) {
        begun(contender.name);
        Trial& trial = trials.emplace_back();
        trial.device = contender.name;
        Film film(all);
        const Result<void> drawn = draw(contender, *scene, film, trial);
        if (!drawn) {
            trial.trouble = drawn.error().line();
        } else if (reference) {
            trial.parity = compare_films(film, *reference);
        } else {
            reference = std::move(film);
        }
    }
    return trials;
}

}  // namespace hm::cli
