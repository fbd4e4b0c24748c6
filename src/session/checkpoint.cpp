#include "session/checkpoint.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

namespace hm {
namespace {

tl::unexpected<Error> refuse(const std::filesystem::path& path, std::string message,
                             std::string setting = {}) {
    return fail_setting(std::move(setting), std::move(message), path.string());
}

// A GPU adds equally many samples to all pixels.
Result<void> check_even(const Film& stored, const std::string& device,
                        const std::filesystem::path& path) {
    if (device == "CPU" || stored.fewest_samples() == stored.most_samples()) return {};
    return refuse(path,
                  fmt::format("has pixels with {} and with {} samples, because a time limit cut "
                              "a pass short; only the CPU completes it",
                              stored.fewest_samples(), stored.most_samples()));
}

Result<void> check_samples(const Film& stored, const SamplingSettings& sampling, const Film& film,
                           const std::filesystem::path& path) {
    if (stored.first_sample != film.first_sample)
        return refuse(path, fmt::format("has samples from {} on, but now they start at {}",
                                        stored.first_sample, film.first_sample));
    const std::uint32_t end = stored.first_sample + stored.most_samples();
    if (end > sampling.end())
        return refuse(path,
                      fmt::format("has samples up to {} already; {} is less", end, sampling.end()));
    return {};
}

FilmLabel label_of(const FrameSettings& frame, const FilmRecord& record) {
    return {frame.width, frame.height, to_notes(record)};
}

}  // namespace

Result<std::optional<Checkpoint>> read_checkpoint(
    const KeepSettings& keep, const std::function<void(std::string_view)>& note) {
    if (keep.resume.empty()) return std::nullopt;
    std::error_code unknown;
    if (keep.begin_if_missing && !std::filesystem::exists(keep.resume, unknown)) {
        note(fmt::format("there is no {} yet: beginning with the first sample",
                         keep.resume.string()));
        return std::nullopt;
    }
    HM_TRY_ASSIGN(StoredFilm stored, read_film(keep.resume));
    HM_TRY_ASSIGN(FilmRecord record, from_notes(stored.label.notes, keep.resume.string()));
    return Checkpoint{std::move(stored.film), std::move(record)};
}

Result<void> check_resumable(const Checkpoint& checkpoint, const KeepSettings& keep,
                             const SamplingSettings& sampling, const NamedValues& now,
                             const std::string& device, const Film& film) {
    const std::filesystem::path& path = keep.resume;
    const std::string differing = differences(checkpoint.record.settings, now, "now");
    if (!differing.empty())
        return refuse(path, fmt::format("is of another picture: {}", differing));
    if (checkpoint.film.crop != film.crop || checkpoint.film.selection != film.selection)
        return refuse(path, "is of another picture: its pixels or layers differ");
    for (const std::string& before : checkpoint.record.devices)
        if (before != device && !keep.any_device)
            return refuse(
                path,
                fmt::format("was rendered by {}; continuing with {} would give the bits of "
                            "neither",
                            before, device),
                "any-device");
    HM_TRY(check_even(checkpoint.film, device, path));
    return check_samples(checkpoint.film, sampling, film, path);
}

Result<void> write_checkpoint(const std::filesystem::path& path, const FrameSettings& frame,
                              const Film& film, const FilmRecord& record) {
    // Uncompressed: noise hardly compresses, and rendering waits.
    return write_film(path, film, label_of(frame, record), ExrCompression::none);
}

Result<void> write_part(const std::filesystem::path& path, const FrameSettings& frame,
                        const Film& film, const FilmRecord& record) {
    return write_film(path, film, label_of(frame, record), ExrCompression::zip);
}

}  // namespace hm
