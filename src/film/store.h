// Stores a film in a file, so that it can be continued or merged with others. The file holds sums
// rather than averages and every id that a pixel has seen, all without rounding. Checkpoints and
// parts are such files: OpenEXR with a checksum. docs/checkpoints.md lists layers and attributes.
#pragma once

#include <cstdint>
#include <filesystem>

#include "base/result.h"
#include "film/film.h"
#include "image/layers.h"

namespace hm {

struct FilmLabel {
    std::uint32_t width = 0, height = 0;  // of the whole picture; the film may be a crop
    Metadata notes;                       // the writer's own key-value pairs
};

struct StoredFilm {
    Film film;
    FilmLabel label;
};

// Names of notes are unique, consist of printable ASCII without blanks, and do not begin with
// kFilmPrefix. Notes with empty text are omitted.
inline constexpr std::string_view kFilmPrefix = "film.";
Result<void> write_film(const std::filesystem::path& path, const Film& film, const FilmLabel& label,
                        ExrCompression compression);

// Fails with ErrorKind::unreadable, invalid (not a film, or damaged) or unsupported (written by a
// later version).
Result<StoredFilm> read_film(const std::filesystem::path& path);

// Approximate size of the uncompressed file, without the lists of ids.
std::uint64_t stored_bytes(const Film& film);

}  // namespace hm
