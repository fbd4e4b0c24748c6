#include "app/cli/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace hm::cli {
namespace {

tl::unexpected<Error> refuse(const std::filesystem::path& path, std::string message) {
    return fail(ErrorKind::invalid_argument, path.string(), "", std::move(message));
}

Result<void> check_frame(const FilmRecord& record, const RenderOptions& options) {
    const std::filesystem::path& path = options.keep.resume;
    if (record.frame && !options.frames)
        return refuse(path,
                      fmt::format("is of frame {} of a sequence; give --frames", *record.frame));
    if (!options.frames) return {};
    if (!record.frame) return refuse(path, "is of a single picture, not of a sequence");
    if (*record.frame < options.frames->first || *record.frame > options.frames->last)
        return refuse(
            path, fmt::format("is of frame {}, which --frames {}:{} does not have", *record.frame,
                              options.frames->first, options.frames->last));
    if (record.samples_asked != options.samples)
        return refuse(path, fmt::format("is of a sequence with --spp {} (now {})",
                                        record.samples_asked, options.samples));
    return {};
}

// A GPU adds as many samples to all pixels.
Result<void> check_even(const Film& stored, const std::string& device,
                        const std::filesystem::path& path) {
    if (device == "CPU" || stored.fewest_samples() == stored.most_samples()) return {};
    return refuse(path, fmt::format("has pixels with {} and with {} samples, as time that was over "
                                    "left them; only the CPU completes it",
                                    stored.fewest_samples(), stored.most_samples()));
}

Result<void> check_samples(const Film& stored, const RenderOptions& options, const Film& film) {
    const std::filesystem::path& path = options.keep.resume;
    if (stored.first_sample != film.first_sample)
        return refuse(path, fmt::format("holds samples from {} on; now they begin at {}",
                                        stored.first_sample, film.first_sample));
    const std::uint32_t end = stored.first_sample + stored.most_samples();
    if (end > options.sample_end())
        return refuse(path, fmt::format("holds samples up to {} already; {} is less", end,
                                        options.sample_end()));
    return {};
}

FilmLabel label_of(const RenderOptions& options, const FilmRecord& record) {
    return {options.width, options.height, to_notes(record)};
}

}  // namespace

Result<std::optional<Checkpoint>> read_checkpoint(
    const RenderOptions& options, const std::function<void(std::string_view)>& note) {
    const KeepOptions& keep = options.keep;
    if (keep.resume.empty()) return std::nullopt;
    std::error_code unknown;
    if (keep.begin_if_missing && !std::filesystem::exists(keep.resume, unknown)) {
        note(fmt::format("there is no {} yet: beginning with the first sample",
                         keep.resume.string()));
        return std::nullopt;
    }
    HM_TRY_ASSIGN(StoredFilm stored, read_film(keep.resume));
    HM_TRY_ASSIGN(FilmRecord record, from_notes(stored.label.notes, keep.resume.string()));
    HM_TRY(check_frame(record, options));
    return Checkpoint{std::move(stored.film), std::move(record)};
}

Result<void> check_resumable(const Checkpoint& checkpoint, const RenderOptions& options,
                             const Settings& now, const std::string& device, const Film& film) {
    const std::filesystem::path& path = options.keep.resume;
    const std::string differing = differences(checkpoint.record.settings, now, "now");
    if (!differing.empty())
        return refuse(path, fmt::format("is of another picture: {}", differing));
    if (checkpoint.film.crop != film.crop || checkpoint.film.selection != film.selection)
        return refuse(path, "is of another picture: its pixels or layers differ");
    for (const std::string& before : checkpoint.record.devices)
        if (before != device && !options.keep.any_device)
            return refuse(path, fmt::format("was drawn by {}; going on with {} would give the bits "
                                            "of neither, and --any-device does it",
                                            before, device));
    HM_TRY(check_even(checkpoint.film, device, path));
    return check_samples(checkpoint.film, options, film);
}

Result<void> write_checkpoint(const RenderOptions& options, const Film& film,
                              const FilmRecord& record) {
    // Uncompressed: noise does not become smaller, and rendering waits.
    return write_film(options.keep.checkpoint, film, label_of(options, record),
                      ExrCompression::none);
}

Result<void> write_part(const std::filesystem::path& path, const RenderOptions& options,
                        const Film& film, const FilmRecord& record) {
    return write_film(path, film, label_of(options, record), ExrCompression::zip);
}

}  // namespace hm::cli
