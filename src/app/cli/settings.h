// All that decides a picture's pixels, by name and as text: stored with sums of samples, so that
// only those of the same picture are added to each other.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/options.h"
#include "film/renderer.h"

namespace hm::cli {

// Flags under their names without dashes, and "program", "scene", "environment" and "params". What
// was left out is not in the list.
using Settings = std::vector<std::pair<std::string, std::string>>;

struct SceneFingerprint {
    std::string scene;        // Scene::hash
    std::string environment;  // its file's hash, "none" or "default"
};

Settings picture_settings(const RenderOptions& options, const RenderJob& job,
                          const AovSelection& selection, const SceneFingerprint& fingerprint);

// "--seed 1 (now 2), the scene file differs": what `these` are, and in brackets what `others` have
// instead, after `word`. Empty where nothing differs.
std::string differences(const Settings& these, const Settings& others, std::string_view word);

}  // namespace hm::cli
