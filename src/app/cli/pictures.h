// The finished pictures of a film, from it and what is recorded of it: those of a rendering and
// those of its parts joined are the same.
#pragma once

#include <filesystem>
#include <vector>

#include "app/cli/film_record.h"
#include "film/denoise.h"
#include "film/film.h"

namespace hm::cli {

struct PicturesReport {
    double denoise_seconds = 0;
    std::uint64_t replaced_pixels = 0;  // that were not finite, by the denoiser
};

// All of them are tried, so that one full disk does not cost every picture; the first error is
// returned. Width and height are the whole picture's. With a denoiser, .exr files get a layer more
// and others show the denoised picture; where it fails, the rendered one is written all the same.
Result<PicturesReport> write_pictures(const std::vector<std::filesystem::path>& paths,
                                      const Film& film, std::uint32_t width, std::uint32_t height,
                                      const FilmRecord& record, const Denoiser* denoiser = nullptr);

}  // namespace hm::cli
