#include "app/cli/merge.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <system_error>
#include <utility>

#include "app/cli/output.h"
#include "app/cli/output_flag.h"
#include "base/files.h"
#include "output/write.h"
#include "session/checkpoint.h"
#include "session/merge.h"
#include "session/pictures.h"

namespace hm::cli {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> refuse(const fs::path& path, std::string message) {
    return fail(ErrorKind::invalid_argument, path.string(), "", std::move(message));
}

Result<void> check_outputs(const MergeOptions& options) {
    for (const fs::path& path : options.outputs) {
        if (options.part && picture_kind(path) != PictureKind::exr)
            return refuse(path, "--part: a part is an .exr");
        std::error_code unknown;
        for (const fs::path& part : options.parts)
            if (fs::equivalent(part, path, unknown))
                return refuse(path, "is one of the parts; it would be lost");
        HM_TRY(check_writable(path));
    }
    return {};
}

// The settings in the metadata name the first part's --samples.
void update_settings(MergedFilm& merged) {
    constexpr std::string_view kFlag = " --samples ";
    for (auto& [name, value] : merged.record.picture) {
        const std::size_t flag = name == "settings" ? value.find(kFlag) : value.npos;
        if (flag == value.npos) continue;
        const std::size_t begin = flag + kFlag.size();
        const std::size_t end = std::min(value.find(' ', begin), value.size());
        const SampleRange samples = merged.samples();
        value.replace(begin, end - begin, fmt::format("{}:{}", samples.begin, samples.end));
    }
}

Result<void> write_outputs(const MergeOptions& options, const MergedFilm& merged) {
    const Film& film = merged.stored.film;
    const FilmLabel& label = merged.stored.label;
    if (!options.part)
        return write_pictures(options.outputs,
                              finish_picture(film, label.width, label.height, merged.record));
    const FrameSettings frame{label.width, label.height, {}};
    Result<void> outcome;
    for (const fs::path& path : options.outputs) {
        Result<void> written = write_part(path, frame, film, merged.record);
        if (!written && outcome) outcome = std::move(written);
    }
    return outcome;
}

}  // namespace

void add_merge_flags(CLI::App& app, MergeOptions& o) {
    const auto add_all = [](std::vector<fs::path>& to) {
        return [&to](const std::vector<std::string>& paths) {
            to.insert(to.end(), paths.begin(), paths.end());
        };
    };
    app.add_option_function<std::vector<std::string>>(
           "PART", add_all(o.parts),
           "Parts (render --samples) of one picture, in any order; checkpoints serve, too")
        ->required();
    add_output_flag(app, o.outputs, "The picture, as render would write it; may be repeated");
    app.add_flag("--part", o.part, "Write a part again, to be joined with others later");
    app.footer(
        "Parts that overlap, leave samples out or are not of the same picture are refused with "
        "exit code 2.");
}

Result<ExitCode> merge(const MergeOptions& options) {
    HM_TRY(check_outputs(options));
    HM_TRY_ASSIGN(MergedFilm merged, merge_parts(options.parts, !options.part));
    update_settings(merged);
    HM_TRY(write_outputs(options, merged));
    const std::size_t count = merged.parts.size();
    tell(fmt::format("himalaya: {} part{}, samples {} to {}, {:.2f} s of rendering on {}\n", count,
                     count == 1 ? "" : "s", merged.samples().begin, merged.samples().end,
                     merged.record.seconds, devices_text(merged.record.devices)));
    return ExitCode::ok;
}

}  // namespace hm::cli
