// Rendering that is never lost: a file that holds all samples so far (--checkpoint), and going on
// from it (--resume).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "app/cli/film_record.h"
#include "app/cli/options.h"
#include "film/store.h"

namespace hm::cli {

struct Checkpoint {
    Film film;
    FilmRecord record;
};

// What --resume names. Nothing without it, or where the file is missing and --checkpoint names it
// too: then it is to be made. Fails where a frame is stored that is not of the sequence.
Result<std::optional<Checkpoint>> read_checkpoint(
    const RenderOptions& options, const std::function<void(std::string_view)>& note);

// Whether samples of this device can be added to the checkpoint's for the picture that `now` says
// and that `film`, still empty, is for. Fails with ErrorKind::invalid_argument, naming what
// differs.
Result<void> check_resumable(const Checkpoint& checkpoint, const RenderOptions& options,
                             const Settings& now, const std::string& device, const Film& film);

// All that is known of the samples, in one file that replaces the last one at once.
Result<void> write_checkpoint(const RenderOptions& options, const Film& film,
                              const FilmRecord& record);

// The same for a part: a range of the samples (--samples).
Result<void> write_part(const std::filesystem::path& path, const RenderOptions& options,
                        const Film& film, const FilmRecord& record);

}  // namespace hm::cli
