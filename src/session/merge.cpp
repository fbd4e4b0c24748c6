#include "session/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "film/variance.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(const std::filesystem::path& path, std::string message,
                             std::string setting = {}) {
    return fail_setting(std::move(setting), std::move(message), path.string());
}

Result<MergedFilm> read_part(const std::filesystem::path& path) {
    HM_TRY_ASSIGN(StoredFilm stored, read_film(path));
    HM_TRY_ASSIGN(FilmRecord record, from_notes(stored.label.notes, path.string()));
    const std::uint32_t first = stored.film.first_sample;
    const MergedPart part{path, {first, first + stored.film.most_samples()}};
    return MergedFilm{std::move(stored), std::move(record), {part}};
}

Result<void> check_even(const MergedFilm& merged) {
    const Film& film = merged.stored.film;
    if (film.fewest_samples() == film.most_samples()) return {};
    return refuse(
        merged.parts[0].path,
        fmt::format("has pixels with {} and with {} samples, because a time limit cut a pass "
                    "short",
                    film.fewest_samples(), film.most_samples()),
        "resume");
}

Result<void> add_part(MergedFilm& merged, MergedFilm more) {
    const MergedPart& part = more.parts[0];
    const MergedPart& first = merged.parts[0];
    const std::string differing = differences(more.record.settings, merged.record.settings,
                                              fmt::format("{} has", first.path.string()));
    if (!differing.empty())
        return refuse(part.path, fmt::format("is of another picture: {}", differing));
    if (more.stored.film.crop != merged.stored.film.crop ||
        more.stored.film.selection != merged.stored.film.selection)
        return refuse(part.path,
                      fmt::format("has other pixels or layers than {}", first.path.string()));
    for (const MergedPart& other : merged.parts)
        if (part.samples.begin < other.samples.end && other.samples.begin < part.samples.end)
            return refuse(part.path,
                          fmt::format("has samples {} to {}; {} has {} to {}", part.samples.begin,
                                      part.samples.end, other.path.string(), other.samples.begin,
                                      other.samples.end));
    merge_film(merged.stored.film, more.stored.film);
    FilmRecord& record = merged.record;
    record.seconds += more.record.seconds;
    record.rays += more.record.rays;
    record.non_finite += more.record.non_finite;
    record.samples_asked = std::max(record.samples_asked, more.record.samples_asked);
    for (std::string& device : more.record.devices)
        if (std::find(record.devices.begin(), record.devices.end(), device) == record.devices.end())
            record.devices.push_back(std::move(device));
    merged.parts.push_back(part);
    return {};
}

// Missing samples are reported with the part that begins after them.
Result<void> check_gaps(std::vector<MergedPart> parts, bool from_zero) {
    std::sort(parts.begin(), parts.end(), [](const MergedPart& a, const MergedPart& b) {
        return a.samples.begin < b.samples.begin;
    });
    std::uint32_t end = from_zero ? 0 : parts[0].samples.begin;
    for (const MergedPart& part : parts) {
        if (part.samples.begin > end)
            return refuse(part.path, fmt::format("starts at sample {}, and no part has {} to {}",
                                                 part.samples.begin, end, part.samples.begin));
        end = part.samples.end;
    }
    return {};
}

// Replaces the text between two others, if they are found.
void replace_between(std::string& text, std::string_view before, std::string_view after,
                     std::string_view by) {
    const std::size_t begin = text.find(before);
    if (begin == text.npos) return;
    const std::size_t from = begin + before.size();
    const std::size_t end = std::min(text.find(after, from), text.size());
    text.replace(from, end - from, by);
}

// Turns the first part's metadata into that of all samples.
void update_metadata(MergedFilm& merged) {
    const Film& film = merged.stored.film;
    const double removed = film.removed_luminance();
    const double all = removed + film.mean_luminance();
    for (auto& [name, value] : merged.record.picture) {
        if (name == "samplesPerPixel") value = fmt::format("{:g}", film.mean_samples());
        if (name == "renderSeconds") value = fmt::format("{:.3f}", merged.record.seconds);
        if (name == "clampRemovedShare") value = fmt::format("{:g}", all > 0 ? removed / all : 0.0);
        if (name == "estimatedError")
            value = fmt::format("{:g}", estimated_error(film).value_or(0));
        if (name == "device") value = devices_text(merged.record.devices);
        if (name == "bias")
            replace_between(value, "removed ", " %",
                            fmt::format("{:.3g}", all > 0 ? 100 * removed / all : 0.0));
    }
}

}  // namespace

Result<MergedFilm> merge_parts(std::span<const std::filesystem::path> paths, bool from_zero) {
    HM_TRY_ASSIGN(MergedFilm merged, read_part(paths[0]));
    if (paths.size() > 1) HM_TRY(check_even(merged));
    for (const std::filesystem::path& path : paths.subspan(1)) {
        HM_TRY_ASSIGN(MergedFilm more, read_part(path));
        HM_TRY(check_even(more));
        HM_TRY(add_part(merged, std::move(more)));
    }
    HM_TRY(check_gaps(merged.parts, from_zero));
    update_metadata(merged);
    return merged;
}

}  // namespace hm
