// The finished pictures of a film, from it and what is recorded of it: those of a rendering and
// those of its parts joined are the same.
#pragma once

#include <filesystem>
#include <vector>

#include "app/cli/film_record.h"
#include "film/film.h"

namespace hm::cli {

// All of them are tried, so that one full disk does not cost every picture; the first error is
// returned. Width and height are the whole picture's.
Result<void> write_pictures(const std::vector<std::filesystem::path>& paths, const Film& film,
                            std::uint32_t width, std::uint32_t height, const FilmRecord& record);

}  // namespace hm::cli
