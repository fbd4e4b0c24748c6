#include "session/fingerprint.h"

#include <fmt/format.h>

#include <span>

#include "base/hash.h"
#include "session/choices.h"

namespace hm {
namespace {

constexpr std::string_view kParams = "params";

template <class Vector>
std::string text_of(const Vector& v) {
    return fmt::format("{},{},{}", v.x, v.y, v.z);
}

class Writer {
  public:
    template <class T>
    void add(std::string name, const T& value) {
        values_.emplace_back(std::move(name), fmt::format("{}", value));
    }
    template <class T>
    void add_if_given(std::string name, const std::optional<T>& value) {
        if (value) add(std::move(name), *value);
    }
    template <class Number>
    void add_if_given(std::string name, const std::optional<glm::vec<3, Number>>& value) {
        if (value) add(std::move(name), text_of(*value));
    }
    void add_if_given(std::string name, const std::string& value) {
        if (!value.empty()) add(std::move(name), value);
    }
    NamedValues take() { return std::move(values_); }

  private:
    NamedValues values_;
};

void add_view(Writer& out, const ViewSettings& view) {
    out.add_if_given("camera", view.camera);
    out.add_if_given("eye", view.eye);
    out.add_if_given("target", view.target);
    out.add_if_given("up", view.up);
    out.add_if_given("fov", view.fov);
    out.add("aperture", view.aperture);
    out.add_if_given("focus", view.focus);
}

void add_light(Writer& out, const LightSettings& light, const PathSettings& path) {
    out.add("env-rotation", light.environment_rotation);
    out.add("env-intensity", light.environment_intensity);
    out.add("background", path.background == kBackgroundEnvironment ? "environment"
                          : path.background == kBackgroundTransparent
                              ? "transparent"
                              : text_of(path.background_color));
    out.add("punctual", name_of(kSwitches, light.punctual));
    out.add("light-units", name_of(kLightUnits, light.units));
    out.add("strategy", name_of(kStrategies, path.strategy));
}

void add_sampling(Writer& out, const FrameSettings& frame, const PathSettings& path) {
    out.add("size", fmt::format("{}x{}", frame.width, frame.height));
    if (frame.crop)
        out.add("crop", fmt::format("{},{},{},{}", frame.crop->x0, frame.crop->y0, frame.crop->x1,
                                    frame.crop->y1));
    out.add("seed", path.seed);
    out.add("sampler", name_of(kSamplers, path.sampler));
    out.add("bounces", path.bounces);
    out.add("clamp", path.clamp);
    out.add("filter", name_of(kPixelFilters, path.filter));
}

// A hash of what the renderer reads, so that a setting missing above is noticed nevertheless.
// Computed values are left out, since mathematical functions differ between processors.
std::string params_hash(RenderParams params) {
    params.environment_range = params.punctual_range = params.emitter_range = {};
    Hasher hash;
    hash.add(std::as_bytes(std::span(&params, 1)));
    return hash.text();
}

const std::string* find(const NamedValues& settings, std::string_view name) {
    for (const auto& [key, value] : settings)
        if (key == name) return &value;
    return nullptr;
}

std::string difference(const std::string& name, const std::string* one, const std::string* other,
                       std::string_view word) {
    if (name == "scene") return "the scene file differs, or one that it reads";
    if (name == "environment") return "the environment differs";
    if (name == kParams) return "other settings of the renderer";
    if (other == nullptr) return fmt::format("{} {} ({} none)", name, *one, word);
    if (one == nullptr) return fmt::format("no {} ({} {})", name, word, *other);
    return fmt::format("{} {} ({} {})", name, *one, word, *other);
}

}  // namespace

NamedValues picture_settings(const RenderSettings& s, const RenderJob& job,
                             const AovSelection& selection, const SceneFingerprint& fingerprint) {
    Writer out;
    out.add("program", "himalaya " HIMALAYA_VERSION);
    out.add("scene", fingerprint.scene);
    out.add("environment", fingerprint.environment);
    out.add_if_given("scene-choice", fingerprint.scene_choice);
    out.add_if_given("variant", fingerprint.variant);
    add_sampling(out, s.frame, s.path);
    out.add("filter-width", job.params.filter_width);
    add_view(out, s.view);
    out.add_if_given("animation", s.animation.animation);
    out.add_if_given("at", s.animation.at);
    add_light(out, s.light, s.path);
    out.add("energy-compensation", name_of(kSwitches, s.path.energy_compensation));
    out.add("diffuse", name_of(kDiffuseModels, s.path.diffuse));
    out.add_if_given("aov", aov_names(selection.aovs));
    if (selection.has(Aov::motion)) out.add("fps", s.animation.fps);
    out.add(std::string(kParams), params_hash(job.params));
    return out.take();
}

std::string differences(const NamedValues& these, const NamedValues& others,
                        std::string_view word) {
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
    // Useful only if no setting above explains the difference.
    const std::string params(kParams);
    if (text.empty()) add(params, find(these, params), find(others, params));
    return text;
}

}  // namespace hm
