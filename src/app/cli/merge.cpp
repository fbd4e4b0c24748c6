#include "app/cli/merge.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <system_error>
#include <utility>

#include "app/cli/checkpoint.h"
#include "app/cli/output.h"
#include "app/cli/output_flag.h"
#include "app/cli/pictures.h"
#include "base/files.h"
#include "film/variance.h"
#include "film/write.h"

namespace hm::cli {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> refuse(const fs::path& path, std::string message) {
    return fail(ErrorKind::invalid_argument, path.string(), "", std::move(message));
}

struct Part {
    fs::path path;
    SampleRange samples;
};

// The parts' samples so far.
struct Joined {
    StoredFilm stored;
    FilmRecord record;
    std::vector<Part> parts;
};

Result<Joined> read_part(const fs::path& path) {
    HM_TRY_ASSIGN(StoredFilm stored, read_film(path));
    HM_TRY_ASSIGN(FilmRecord record, from_notes(stored.label.notes, path.string()));
    const std::uint32_t first = stored.film.first_sample;
    const Part part{path, {first, first + stored.film.most_samples()}};
    return Joined{std::move(stored), std::move(record), {part}};
}

Result<void> check_even(const Joined& joined) {
    const Film& film = joined.stored.film;
    if (film.fewest_samples() == film.most_samples()) return {};
    return refuse(joined.parts[0].path,
                  fmt::format("has pixels with {} and with {} samples, as time that was over left "
                              "them; --resume completes it",
                              film.fewest_samples(), film.most_samples()));
}

Result<void> add_part(Joined& joined, Joined more) {
    const Part& part = more.parts[0];
    const Part& first = joined.parts[0];
    const std::string differing = differences(more.record.settings, joined.record.settings,
                                              fmt::format("{} has", first.path.string()));
    if (!differing.empty())
        return refuse(part.path, fmt::format("is of another picture: {}", differing));
    if (more.stored.film.crop != joined.stored.film.crop ||
        more.stored.film.selection != joined.stored.film.selection)
        return refuse(part.path,
                      fmt::format("has other pixels or layers than {}", first.path.string()));
    for (const Part& other : joined.parts)
        if (part.samples.begin < other.samples.end && other.samples.begin < part.samples.end)
            return refuse(part.path,
                          fmt::format("holds samples {} to {}; {} holds {} to {}",
                                      part.samples.begin, part.samples.end, other.path.string(),
                                      other.samples.begin, other.samples.end));
    merge_film(joined.stored.film, more.stored.film);
    FilmRecord& record = joined.record;
    record.seconds += more.record.seconds;
    record.rays += more.record.rays;
    record.non_finite += more.record.non_finite;
    record.samples_asked = std::max(record.samples_asked, more.record.samples_asked);
    for (std::string& device : more.record.devices)
        if (std::find(record.devices.begin(), record.devices.end(), device) == record.devices.end())
            record.devices.push_back(std::move(device));
    joined.parts.push_back(part);
    return {};
}

// Samples that nobody has are named with the part that begins after them.
Result<void> check_gaps(std::vector<Part> parts, bool from_zero) {
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.samples.begin < b.samples.begin; });
    std::uint32_t end = from_zero ? 0 : parts[0].samples.begin;
    for (const Part& part : parts) {
        if (part.samples.begin > end)
            return refuse(part.path, fmt::format("begins with sample {}, and no part has {} to {}",
                                                 part.samples.begin, end, part.samples.begin));
        end = part.samples.end;
    }
    return {};
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

// The text between two others becomes another; nothing changes where they are not found.
void replace_between(std::string& text, std::string_view before, std::string_view after,
                     std::string_view by) {
    const std::size_t begin = text.find(before);
    if (begin == text.npos) return;
    const std::size_t from = begin + before.size();
    const std::size_t end = std::min(text.find(after, from), text.size());
    text.replace(from, end - from, by);
}

// What the first part says of itself becomes what is true of all samples.
void update_metadata(Joined& joined) {
    const Film& film = joined.stored.film;
    const double removed = film.removed_luminance();
    const double all = removed + film.mean_luminance();
    const std::string samples =
        fmt::format("{}:{}", film.first_sample, film.first_sample + film.most_samples());
    for (auto& [name, value] : joined.record.picture) {
        if (name == "samplesPerPixel") value = fmt::format("{:g}", film.mean_samples());
        if (name == "renderSeconds") value = fmt::format("{:.3f}", joined.record.seconds);
        if (name == "clampRemovedShare") value = fmt::format("{:g}", all > 0 ? removed / all : 0.0);
        if (name == "estimatedError")
            value = fmt::format("{:g}", estimated_error(film).value_or(0));
        if (name == "device") value = devices_text(joined.record.devices);
        if (name == "settings") replace_between(value, " --samples ", " ", samples);
        if (name == "bias")
            replace_between(value, "removed ", " %",
                            fmt::format("{:.3g}", all > 0 ? 100 * removed / all : 0.0));
    }
}

Result<void> write_outputs(const MergeOptions& options, const Joined& joined) {
    const Film& film = joined.stored.film;
    const FilmLabel& label = joined.stored.label;
    if (!options.part)
        return write_pictures(options.outputs, film, label.width, label.height, joined.record)
            .map([](const PicturesReport&) {});
    Result<void> outcome;
    for (const fs::path& path : options.outputs) {
        Result<void> written = write_film(
            path, film, {label.width, label.height, to_notes(joined.record)}, ExrCompression::zip);
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
    // One after the other: two films are in memory, however many parts there are.
    HM_TRY_ASSIGN(Joined joined, read_part(options.parts[0]));
    if (options.parts.size() > 1) HM_TRY(check_even(joined));
    for (std::size_t i = 1; i < options.parts.size(); ++i) {
        HM_TRY_ASSIGN(Joined more, read_part(options.parts[i]));
        HM_TRY(check_even(more));
        HM_TRY(add_part(joined, std::move(more)));
    }
    HM_TRY(check_gaps(joined.parts, !options.part));
    update_metadata(joined);
    HM_TRY(write_outputs(options, joined));
    const Film& film = joined.stored.film;
    tell(fmt::format("himalaya: {} part{}, samples {} to {}, {:.2f} s of rendering on {}\n",
                     joined.parts.size(), joined.parts.size() == 1 ? "" : "s", film.first_sample,
                     film.first_sample + film.most_samples(), joined.record.seconds,
                     devices_text(joined.record.devices)));
    return ExitCode::ok;
}

}  // namespace hm::cli
