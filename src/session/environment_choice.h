// The environment that lights a scene.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/environment.h"
#include "scene/scene.h"
#include "session/settings.h"

namespace hm {

struct EnvironmentChoice {
    EnvironmentMap map;
    std::string name;  // the file, "none" or "default"
    std::string hash;  // of the file's bytes (base/hash.h), else empty
};

// The settings' file, black, or the default sky if no punctual light is used.
// What was wrong with the file although it could be read is a warning.
Result<EnvironmentChoice> choose_environment(const LightSettings& light, const Scene& scene,
                                             Diagnostics& diagnostics);

}  // namespace hm
