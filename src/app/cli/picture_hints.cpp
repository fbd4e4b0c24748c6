#include "app/cli/picture_hints.h"

#include <fmt/format.h>

#include <algorithm>

#include "output/tonemap.h"
#include "output/write.h"

namespace hm::cli {
namespace {

constexpr double kMost = 0.5;
constexpr double kAlmostAll = 0.999;

bool writes_png(const RenderOptions& options) {
    return std::ranges::any_of(options.outputs, [](const std::filesystem::path& path) {
        return picture_kind(path) == PictureKind::png;
    });
}

bool is_first_frame(const RenderOptions& options) {
    return !options.frames || options.settings.animation.frame == options.frames->first;
}

std::string missed_hint(const RenderSummary& summary) {
    return std::string("no camera ray hit the scene; ") +
           (summary.camera == "framing" ? "--eye and --target choose another view"
                                        : "--camera none frames all of it");
}

std::string unlit_hint(const RenderOptions& options, const RenderSummary& summary) {
    std::string text = "the picture is black: no light reaches the camera";
    if (options.settings.light.environment == EnvironmentKind::none)
        text += "; without --env none a default environment lights it";
    else if (summary.environment == "none")
        text +=
            "; --env FILE adds light, --punctual off replaces the file's lights by a default "
            "environment";
    return text;
}

// PNG files only: other files hold radiance, which clips nowhere.
std::optional<std::string> exposure_hint(const RenderOptions& options, const Film& film) {
    const DisplaySettings& display = options.settings.display;
    if (!display.exposure || !writes_png(options)) return std::nullopt;
    const ToneShares shares = tone_shares(
        tone_map_picture(film.resolve(), film.crop, {*display.exposure, display.tone_curve}));
    if (shares.clipped > kMost)
        return fmt::format("{:.0f} % of the pixels are too bright and clip; see --exposure auto",
                           100 * shares.clipped);
    if (shares.black > kAlmostAll) return "the picture is too dark to be seen; see --exposure auto";
    return std::nullopt;
}

}  // namespace

std::optional<std::string> picture_hint(const RenderOptions& options, const RenderSummary& summary,
                                        const Film& film) {
    if (!is_first_frame(options)) return std::nullopt;
    if (summary.missed_everything()) return missed_hint(summary);
    if (summary.mean_luminance <= 0) return unlit_hint(options, summary);
    return exposure_hint(options, film);
}

}  // namespace hm::cli
