#include "app/cli/denoise.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>

#include "app/cli/flag.h"
#include "app/cli/output.h"
#include "app/cli/output_flag.h"
#include "app/cli/tone_flags.h"
#include "app/cli/values.h"
#include "base/files.h"
#include "base/json_writer.h"
#include "image/layers.h"
#include "output/write.h"
#include "session/choices.h"

namespace hm::cli {
namespace {

Result<void> write_one(const std::filesystem::path& path, const DenoiseOptions& options,
                       const LayeredImage& picture, const FloatImage& denoised) {
    // .png and .hdr are Rec. 709.
    if (picture.to_rec709 && picture_kind(path) != PictureKind::exr) {
        LayeredImage converted = picture;
        converted.to_rec709.reset();
        return write_one(path, options, converted, convert(denoised, *picture.to_rec709));
    }
    const PictureWindow& data = picture.data;
    const float exposure = options.exposure ? *options.exposure : auto_exposure(denoised);
    // Dither follows the whole picture, whose pixels may start at a negative number.
    const auto x = std::uint32_t(std::max(data.x0 - picture.display.x0, 0));
    const auto y = std::uint32_t(std::max(data.y0 - picture.display.y0, 0));
    return write_picture(path, denoised, picture,
                         {.crop = {x, y, x + data.width(), y + data.height()},
                          .alpha = picture.find("")->find("A") != nullptr,
                          .tone = {exposure, options.tone_curve}});
}

std::string changes(const Denoised& denoised) {
    std::string text;
    if (denoised.replaced_pixels > 0)
        text += fmt::format("; {} pixels were not finite and were filled from their neighbours",
                            denoised.replaced_pixels);
    if (denoised.negative_pixels > 0)
        text += fmt::format("; {} pixels had negative values, which became 0",
                            denoised.negative_pixels);
    return text;
}

std::string report(const DenoiseOptions& options, const std::string& device,
                   const Denoised& denoised) {
    if (!options.json)
        return fmt::format("{}, {:.2f} s{}\n", device, denoised.seconds, changes(denoised));
    JsonWriter json;
    json.begin_object().field("program", "himalaya " HIMALAYA_VERSION);
    json.field("input", options.input.string()).field("denoiser", device);
    json.field("seconds", denoised.seconds).field("replaced_pixels", denoised.replaced_pixels);
    json.field("negative_pixels", denoised.negative_pixels);
    json.key("outputs").begin_array();
    for (const std::filesystem::path& path : options.outputs)
        json.value(path.string());
    json.end_array().end_object();
    return json.text() + "\n";
}

}  // namespace

CLI::Option* add_denoise_device(CLI::App& app, const std::string& flag, DenoiseDevice& device) {
    return add(
        app, flag, "NAME", device,
        [](const std::string& text) { return parse_choice(text, kDenoiseDevices); },
        "What denoises: auto (the fastest there is, the default), cpu, cuda, hip or sycl");
}

void add_denoise_flags(CLI::App& app, DenoiseOptions& o) {
    app.add_option("FILE", o.input, "An .exr with the layers albedo and normal")->required();
    add_output_flag(
        app, o.outputs,
        "Where to write; may be repeated. .exr: all layers of FILE and the layer \"denoised\". "
        ".png and .hdr: the denoised picture");
    add_denoise_device(app, "--device", o.device);
    CLI::Option* none = app.add_flag("--without-guides", o.guidance.without,
                                     "Denoise by the colours alone: details are lost");
    app.add_flag("--clean-guides", o.guidance.clean,
                 "The albedo and normal layers are free of noise: use them as they are")
        ->excludes(none);
    add(
        app, "--threads", "N", o.threads,
        [](const std::string& text) { return parse_integer(text, 0, 1024); },
        "Threads; 0: all cores (the default)");
    add_tone_flags(app, o.exposure, o.tone_curve);
    app.add_flag("--json", o.json, "Print JSON instead of text");
}

Result<ExitCode> denoise(const DenoiseOptions& options) {
    for (const std::filesystem::path& path : options.outputs)
        HM_TRY(check_writable(path));
    HM_TRY_ASSIGN(LayeredImage picture, read_layers(options.input));
    HM_TRY_ASSIGN(const Denoiser denoiser, Denoiser::open(options.device, options.threads));
    Result<Denoised> denoised = denoise_layers(denoiser, picture, options.guidance);
    if (!denoised) {
        if (denoised.error().kind == ErrorKind::invalid)
            denoised.error().file = options.input.string();
        return tl::unexpected(std::move(denoised.error()));
    }
    for (const std::filesystem::path& path : options.outputs)
        HM_TRY(write_one(path, options, picture, denoised->picture));
    HM_TRY(print(report(options, denoiser.description(), *denoised)));
    return ExitCode::ok;
}

}  // namespace hm::cli
