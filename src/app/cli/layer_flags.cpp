#include "app/cli/layer_flags.h"

#include <CLI/CLI.hpp>

#include "app/cli/flag.h"
#include "app/cli/values.h"
#include "output/layers.h"
#include "session/choices.h"

namespace hm::cli {
namespace {

constexpr std::uint32_t kMinTile = 8, kMaxTile = 4096;

}  // namespace

void add_layer_flags(CLI::App& app, LayerSettings& o) {
    std::string names;
    for (const AovInfo& info : all_aovs())
        names += std::string(names.empty() ? "" : ", ") + std::string(info.name);
    add(app, "--aov", "NAMES|all", o.aovs, parse_aovs,
        "Layers of .exr files beside the beauty, separated by commas: " + names +
            ". all leaves out variance, which makes the beauty noisier: add it as all,variance");
    app.add_flag("--light-groups", o.light_groups,
                 "The beauty split by light, emissive material and environment, as --aov "
                 "light_groups");
    add(
        app, "--exr-compression", "NAME", o.exr.compression,
        [](const std::string& text) { return parse_choice(text, kExrCompressions); },
        "none, rle, zips, zip (the default), piz, or lossy pxr24, b44, b44a, dwaa, dwab");
    add(app, "--exr-half", "NAMES|all", o.half, parse_half,
        "Store these layers in 16 bits: beauty, names of AOVs, or all that allow it. Others have "
        "32 "
        "bits");
    add(
        app, "--exr-tiles", "SIDE", o.exr.tile,
        [](const std::string& text) { return parse_integer(text, kMinTile, kMaxTile); },
        "Store square tiles of this many pixels instead of scan lines");
}

}  // namespace hm::cli
