#include "app/cli/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "base/hash.h"

namespace hm::cli {
namespace {

constexpr std::array kSamplers = {"independent", "sobol-blue-noise", "sobol-owen"};
constexpr std::array kStrategies = {"mis", "light", "bsdf"};
constexpr std::array kDiffuses = {"lambert", "burley"};
constexpr std::array kFilters = {"box", "gaussian", "blackman-harris"};

constexpr std::string_view kParams = "params";

std::string text_of(vec3 v) {
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

class Writer {
  public:
    template <class T>
    void add(std::string name, const T& value) {
        settings_.emplace_back(std::move(name), fmt::format("{}", value));
    }
    template <class T>
    void add_if_given(std::string name, const std::optional<T>& value) {
        if (value) add(std::move(name), *value);
    }
    void add_if_given(std::string name, const std::optional<vec3>& value) {
        if (value) add(std::move(name), text_of(*value));
    }
    void add_if_given(std::string name, const std::string& value) {
        if (!value.empty()) add(std::move(name), value);
    }
    Settings take() { return std::move(settings_); }

  private:
    Settings settings_;
};

void add_view(Writer& out, const ViewOptions& view) {
    out.add_if_given("camera", view.camera);
    out.add_if_given("eye", view.eye);
    out.add_if_given("target", view.target);
    out.add_if_given("up", view.up);
    out.add_if_given("fov", view.fov);
    out.add("aperture", view.aperture);
    out.add_if_given("focus", view.focus);
}

void add_light(Writer& out, const RenderOptions& o) {
    out.add("env-rotation", o.env_rotation);
    out.add("env-intensity", o.env_intensity);
    out.add("background", o.background == kBackgroundEnvironment   ? "environment"
                          : o.background == kBackgroundTransparent ? "transparent"
                                                                   : text_of(o.background_color));
    out.add("punctual", o.punctual ? "on" : "off");
    out.add("strategy", kStrategies.at(o.strategy));
}

void add_sampling(Writer& out, const RenderOptions& o) {
    out.add("size", fmt::format("{}x{}", o.width, o.height));
    if (o.crop)
        out.add("crop", fmt::format("{},{},{},{}", o.crop->x0, o.crop->y0, o.crop->x1, o.crop->y1));
    out.add("seed", o.seed);
    out.add("sampler", kSamplers.at(o.sampler));
    out.add("bounces", o.bounces);
    out.add("clamp", o.clamp);
    out.add("filter", kFilters.at(std::size_t(o.filter)));
}

// What the renderer is told once more: a flag that is missing above is noticed all the same. What
// was computed is left out, since mathematical functions differ between processors.
std::string params_hash(RenderParams params) {
    params.environment_range = params.punctual_range = params.emitter_range = {};
    Hasher hash;
    hash.add(std::as_bytes(std::span(&params, 1)));
    return hash.text();
}

const std::string* find(const Settings& settings, std::string_view name) {
    for (const auto& [key, value] : settings)
        if (key == name) return &value;
    return nullptr;
}

std::string difference(const std::string& name, const std::string* one, const std::string* other,
                       std::string_view word) {
    if (name == "scene") return "the scene file differs, or one that it reads";
    if (name == "environment") return "the environment differs";
    if (name == kParams) return "other settings of the renderer";
    const std::string dashes = name == "program" ? "" : "--";
    if (other == nullptr) return fmt::format("{}{} {} ({} none)", dashes, name, *one, word);
    if (one == nullptr) return fmt::format("no {}{} ({} {})", dashes, name, word, *other);
    return fmt::format("{}{} {} ({} {})", dashes, name, *one, word, *other);
}

}  // namespace

Settings picture_settings(const RenderOptions& o, const RenderJob& job,
                          const AovSelection& selection, const SceneFingerprint& fingerprint) {
    Writer out;
    out.add("program", "himalaya " HIMALAYA_VERSION);
    out.add("scene", fingerprint.scene);
    out.add("environment", fingerprint.environment);
    out.add_if_given("scene-choice", o.load.scene);
    out.add_if_given("variant", o.load.variant);
    add_sampling(out, o);
    out.add("filter-width", job.params.filter_width);
    add_view(out, o.view);
    out.add_if_given("animation", o.animation);
    out.add_if_given("at", o.at);
    add_light(out, o);
    out.add("energy-compensation", o.energy_compensation ? "on" : "off");
    out.add("diffuse", kDiffuses.at(o.diffuse));
    out.add_if_given("aov", aov_names(selection.aovs));
    if (selection.has(Aov::motion)) out.add("fps", o.fps);
    out.add(std::string(kParams), params_hash(job.params));
    return out.take();
}

std::string differences(const Settings& these, const Settings& others, std::string_view word) {
    std::string text;
    const auto add = [&](const std::string& name, const std::string* one,
                         const std::string* other) {
        const bool differs = one && other ? *one != *other : one != other;
        if (differs)
            text +=
                fmt::format("{}{}", text.empty() ? "" : ", ", difference(name, one, other, word));
    };
    for (const auto& [name, value] : these)
        if (name != kParams) add(name, &value, find(others, name));
    for (const auto& [name, value] : others)
        if (name != kParams && find(these, name) == nullptr) add(name, nullptr, &value);
    // Of use only where no flag tells.
    const std::string params(kParams);
    if (text.empty()) add(params, find(these, params), find(others, params));
    return text;
}

}  // namespace hm::cli
