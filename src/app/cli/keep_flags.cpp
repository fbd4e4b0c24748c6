#include "app/cli/keep_flags.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <system_error>

#include "app/cli/flag.h"
#include "app/cli/values.h"
#include "base/files.h"

namespace hm::cli {
namespace {

Parsed<SampleRange> parse_samples(const std::string& text) {
    const std::size_t colon = text.find(':');
    const auto wrong = [&] {
        return tl::unexpected(fmt::format("\"{}\" is not a range A:B of samples with A < B <= {}",
                                          text, kMaxSamples));
    };
    if (colon == text.npos) return wrong();
    const auto begin = parse_integer(text.substr(0, colon), 0, kMaxSamples);
    const auto end = parse_integer(text.substr(colon + 1), 1, kMaxSamples);
    if (!begin || !end || *begin >= *end) return wrong();
    return SampleRange{*begin, *end};
}

Parsed<std::filesystem::path> parse_path(const std::string& text) {
    return std::filesystem::path(text);
}

}  // namespace

void add_keep_flags(CLI::App& app, RenderOptions& options) {
    KeepSettings& o = options.keep;
    add(app, "--checkpoint", "FILE", o.checkpoint, parse_path,
        "Keep all samples in this file, an OpenEXR of sums, while rendering and at the end. An "
        "existing file is replaced only by --resume");
    add(
        app, "--every", "SECONDS", o.every,
        [](const std::string& text) { return parse_number(text, 0.01f, 1e9f); },
        "How often the checkpoint is written (60)");
    add(app, "--resume", "FILE", o.resume, parse_path,
        "Continue this checkpoint with the same flags, and keep writing it: to the same pixels as "
        "without the interruption, to more samples with a larger --spp, or in a sequence from the "
        "frame that was being rendered. With --checkpoint of the same name it need not exist yet");
    app.add_flag("--any-device", o.any_device,
                 "Let --resume continue what another device rendered");
    add(app, "--samples", "A:B", options.settings.sampling.range, parse_samples,
        "Render only this range of the samples, counted from 0, B excluded. An .exr is then a "
        "part: "
        "sums that himalaya merge joins with others");
}

Result<void> check_keep_options(const RenderOptions& options) {
    const KeepSettings& o = options.keep;
    const auto usage = [](std::string message) {
        return fail(ErrorKind::invalid_argument, "", "", std::move(message));
    };
    if (o.any_device && o.resume.empty()) return usage("--any-device: is for --resume");
    if (o.checkpoint.empty()) {
        if (o.every) return usage("--every: is for --checkpoint and --resume");
        return {};
    }
    for (const std::filesystem::path& path : options.outputs)
        if (path == o.checkpoint)
            return usage(fmt::format("--checkpoint: \"{}\" is an output, too", path.string()));
    std::error_code unknown;
    if (o.checkpoint != o.resume && std::filesystem::exists(o.checkpoint, unknown))
        return fail(ErrorKind::invalid_argument, o.checkpoint.string(), "",
                    "exists already: continue it with --resume, or remove it to start over");
    return check_writable(o.checkpoint);
}

}  // namespace hm::cli
