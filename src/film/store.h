// A film in a file, to go on with or to join with others: sums and not averages, every id that a
// pixel saw, nothing rounded. Checkpoints and parts are such files. They are OpenEXR, with a
// checksum; docs/checkpoints.md lists layers and attributes.
#pragma once

#include <cstdint>
#include <filesystem>

#include "base/result.h"
#include "film/film.h"
#include "image/layers.h"

namespace hm {

struct FilmLabel {
    std::uint32_t width = 0, height = 0;  // of the whole picture, which the film may be a crop of
    Metadata notes;                       // what its writer has to say, by name
};

struct StoredFilm {
    Film film;
    FilmLabel label;
};

// Notes have names of printable ASCII without blanks, none twice and none that begins with
// kFilmPrefix. A note without text is left out.
inline constexpr std::string_view kFilmPrefix = "film.";
Result<void> write_film(const std::filesystem::path& path, const Film& film, const FilmLabel& label,
                        ExrCompression compression);

// Fails with ErrorKind::unreadable, invalid (not such a file, or a damaged one) or unsupported (of
// a later version).
Result<StoredFilm> read_film(const std::filesystem::path& path);

// About the size of its file without compression, beside lists of ids.
std::uint64_t stored_bytes(const Film& film);

}  // namespace hm
