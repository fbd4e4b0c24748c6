#include "session/settings.h"

#include <fmt/format.h>

#include "base/available_memory.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(std::string setting, std::string message) {
    return fail_setting(std::move(setting), std::move(message));
}

// Of the film and the file for one pixel's AOVs, about.
double layer_bytes_per_pixel(const LayerSettings& layers) {
    double floats = 0;
    for (const Aov aov : layers.aovs) {
        const AovInfo& info = aov_info(aov);
        floats += double(info.channels.size() + 1);
        if (info.plane == kPlaneReplicates) floats += 4 * kReplicates;
        // Id lists with their overhead, at least six ranks of ids and coverage.
        if (info.value == AovValue::ids) floats += 24;
    }
    constexpr double kCopies = 3;  // the film's, the layer's, the file's
    return kCopies * sizeof(float) * floats;
}

Result<void> check_memory(const RenderSettings& settings) {
    // Sums, the resolved picture and what the formats make of it.
    constexpr double kBeautyBytes = 80, kGiB = 1024.0 * 1024.0 * 1024.0;
    const double bytes_per_pixel = kBeautyBytes + layer_bytes_per_pixel(settings.layers);
    const PixelRect pixels = settings.frame.pixels();
    const double need = double(pixels.width()) * double(pixels.height()) * bytes_per_pixel / kGiB;
    const MemoryFacts memory = memory_facts();
    const double available = double(memory.available_bytes) / kGiB;
    if (memory.total_bytes == 0 || need <= available) return {};
    return refuse("size",
                  fmt::format("needs {:.1f} GiB and {:.1f} are available; a crop needs less", need,
                              available));
}

}  // namespace

Result<void> check_settings(const RenderSettings& s) {
    const FrameSettings& frame = s.frame;
    if (frame.width == 0 || frame.height == 0) return refuse("size", "has no pixels");
    if (frame.crop && (frame.crop->x0 >= frame.crop->x1 || frame.crop->y0 >= frame.crop->y1))
        return refuse("crop", "has no pixels");
    if (frame.crop && (frame.crop->x1 > frame.width || frame.crop->y1 > frame.height))
        return refuse("crop", fmt::format("reaches beyond the picture's {} x {} pixels",
                                          frame.width, frame.height));
    HM_TRY(check_memory(s));
    if (s.path.filter_width && *s.path.filter_width <= 0)
        return refuse("filter-width", "must be above 0");
    if (s.view.up && *s.view.up == vec3(0)) return refuse("up", "must have a length");
    if (s.view.eye && s.view.target && *s.view.target == *s.view.eye)
        return refuse("target", "is the same point as the eye");
    return {};
}

RenderSettings settings_of_frame(const RenderSettings& settings, std::uint32_t number) {
    RenderSettings frame = settings;
    frame.animation.frame = number;
    frame.animation.at = float(double(number) / double(settings.animation.fps));
    // Frame 0 has the seed itself; an odd factor keeps all others apart.
    frame.path.seed = settings.path.seed + number * 0x9e3779b9u;
    return frame;
}

}  // namespace hm
