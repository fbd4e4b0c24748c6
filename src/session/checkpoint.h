// Rendering that survives an interruption: a file that holds all samples so far, and resuming from
// it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "film/store.h"
#include "session/film_record.h"
#include "session/settings.h"

namespace hm {

struct Checkpoint {
    Film film;
    FilmRecord record;
};

// What keep.resume names; nothing without it, or if the file does not exist and need not.
Result<std::optional<Checkpoint>> read_checkpoint(
    const KeepSettings& keep, const std::function<void(std::string_view)>& note);

// Whether samples of this device can be added to the checkpoint's, for the picture described by
// `now` and `film`, which is still empty. Fails with ErrorKind::invalid_argument, naming what
// differs.
Result<void> check_resumable(const Checkpoint& checkpoint, const KeepSettings& keep,
                             const SamplingSettings& sampling, const NamedValues& now,
                             const std::string& device, const Film& film);

// Replaces the previous checkpoint in one step.
Result<void> write_checkpoint(const std::filesystem::path& path, const FrameSettings& frame,
                              const Film& film, const FilmRecord& record);

// The same for a part: a range of the samples.
Result<void> write_part(const std::filesystem::path& path, const FrameSettings& frame,
                        const Film& film, const FilmRecord& record);

}  // namespace hm
