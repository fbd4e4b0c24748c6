// Everything that decides a picture's pixels, by name and as text: stored with sums of samples, so
// that only those of the same picture are added to each other.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "film/renderer.h"
#include "session/settings.h"

namespace hm {

using NamedValues = std::vector<std::pair<std::string, std::string>>;

// The inputs: which scene file, which part of it, which environment.
struct SceneFingerprint {
    std::string scene;           // Scene::hash
    std::string scene_choice{};  // LoadOptions::scene
    std::string variant{};       // LoadOptions::variant
    std::string environment{};   // its file's hash, "none" or "default"
};

// The settings by their names, and "program", "scene", "environment" and "params". Settings without
// a value are not in the list.
NamedValues picture_settings(const RenderSettings& settings, const RenderJob& job,
                             const AovSelection& selection, const SceneFingerprint& fingerprint);

// "seed 1 (now 2), the scene file differs": the values of `these`, and in brackets those of
// `others`, after `word`. Empty if nothing differs.
std::string differences(const NamedValues& these, const NamedValues& others, std::string_view word);

}  // namespace hm
