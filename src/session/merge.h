// Merges parts of a rendering, each a range of the samples, into one film.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "film/store.h"
#include "session/film_record.h"
#include "session/settings.h"

namespace hm {

struct MergedPart {
    std::filesystem::path path;
    SampleRange samples;
};

// The samples of all parts so far.
struct MergedFilm {
    StoredFilm stored;
    FilmRecord record;
    std::vector<MergedPart> parts;

    SampleRange samples() const {
        const Film& film = stored.film;
        return {film.first_sample, film.first_sample + film.most_samples()};
    }
};

// Reads one part after the other, so that only two films are in memory. Parts that overlap, leave
// samples out or are of different pictures are refused; with `from_zero` the samples must begin
// with the first.
Result<MergedFilm> merge_parts(std::span<const std::filesystem::path> paths, bool from_zero);

}  // namespace hm
