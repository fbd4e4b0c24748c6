#include "session/environment_choice.h"

#include <algorithm>

#include "base/files.h"
#include "base/hash.h"
#include "image/read.h"

namespace hm {
namespace {

bool has_punctual_light(const Scene& scene) {
    return std::any_of(scene.nodes.begin(), scene.nodes.end(),
                       [](const Node& node) { return node.light != kUnset; });
}

}  // namespace

Result<EnvironmentChoice> choose_environment(const LightSettings& light, const Scene& scene,
                                             Diagnostics& diagnostics) {
    const bool automatic = light.environment == EnvironmentKind::automatic;
    if (light.environment == EnvironmentKind::none ||
        (automatic && light.punctual && has_punctual_light(scene)))
        return EnvironmentChoice{{}, "none", ""};
    if (automatic)
        return EnvironmentChoice{make_environment(default_environment(), light.environment_rotation,
                                                  light.environment_intensity),
                                 "default", ""};
    const std::string file = light.environment_file.string();
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(light.environment_file));
    ReadWarnings warnings;
    HM_TRY_ASSIGN(const FloatImage image, read_environment_image(bytes, file, warnings));
    for (std::string& warning : warnings)
        diagnostics.warn(file, "", std::move(warning));
    Hasher hash;
    hash.add(bytes);
    return EnvironmentChoice{
        make_environment(image, light.environment_rotation, light.environment_intensity), file,
        hash.text()};
}

}  // namespace hm
