#include "app/cli/layer_flags.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/flag.h"
#include "app/cli/values.h"
#include "film/layers.h"

namespace hm::cli {
namespace {

constexpr std::uint32_t kMinTile = 8, kMaxTile = 4096;

Parsed<ExrCompression> parse_compression(const std::string& text) {
    return parse_choice<ExrCompression>(text, {{"none", ExrCompression::none},
                                               {"rle", ExrCompression::rle},
                                               {"zips", ExrCompression::zips},
                                               {"zip", ExrCompression::zip},
                                               {"piz", ExrCompression::piz},
                                               {"pxr24", ExrCompression::pxr24},
                                               {"b44", ExrCompression::b44},
                                               {"b44a", ExrCompression::b44a},
                                               {"dwaa", ExrCompression::dwaa},
                                               {"dwab", ExrCompression::dwab}});
}

// Ids are equal or they are nothing: no bit of them may change. B44 leaves 32-bit floats alone.
bool needs_every_bit(Aov aov) {
    return aov_info(aov).value == AovValue::ids || aov == Aov::material_id ||
           aov == Aov::instance_id;
}

}  // namespace

void add_layer_flags(CLI::App& app, LayerOptions& o) {
    std::string names;
    for (const AovInfo& info : all_aovs())
        names += std::string(names.empty() ? "" : ", ") + std::string(info.name);
    add(app, "--aov", "NAMES|all", o.aovs, parse_aovs,
        "Layers of .exr files beside the beauty, separated by commas: " + names +
            ". all leaves out variance, which alone makes the beauty noisier: all,variance");
    app.add_flag("--light-groups", o.light_groups,
                 "The beauty once more for each light, each emissive material and the environment "
                 "alone, as --aov light_groups");
    add(app, "--exr-compression", "NAME", o.exr.compression, parse_compression,
        "none, rle, zips, zip (the default), piz, or with loss pxr24, b44, b44a, dwaa, dwab");
    add(app, "--exr-half", "NAMES|all", o.half, parse_half,
        "Store these layers in 16 bits: beauty, names of AOVs, or all that it suits. Others are 32 "
        "bits");
    add(
        app, "--exr-tiles", "SIDE", o.exr.tile,
        [](const std::string& text) { return parse_integer(text, kMinTile, kMaxTile); },
        "Store square tiles of so many pixels instead of scan lines");
}

Result<void> check_layer_options(const LayerOptions& options) {
    const ExrCompression compression = options.exr.compression;
    if (is_lossless(compression) || compression == ExrCompression::b44 ||
        compression == ExrCompression::b44a)
        return {};
    for (const Aov aov : options.aovs)
        if (needs_every_bit(aov))
            return fail(ErrorKind::invalid_argument, "", "",
                        fmt::format("--exr-compression: changes values, and {} does not bear it; "
                                    "use none, rle, zips, zip or piz",
                                    aov_info(aov).name));
    return {};
}

double layer_bytes_per_pixel(const LayerOptions& options) {
    double floats = 0;
    for (const Aov aov : options.aovs) {
        const AovInfo& info = aov_info(aov);
        floats += double(info.channels.size() + 1);
        if (info.plane == kPlaneReplicates) floats += 4 * kReplicates;
        // Id lists with their overhead, at least six ranks of ids and coverage.
        if (info.value == AovValue::ids) floats += 24;
    }
    constexpr double kCopies = 3;  // the film's, the layer's, the file's
    return kCopies * sizeof(float) * floats;
}

}  // namespace hm::cli
