// The finished pictures of a film and its record: those of a rendering and those of its merged
// parts are the same.
#pragma once

#include <filesystem>
#include <vector>

#include "film/denoise.h"
#include "film/film.h"
#include "session/film_record.h"

namespace hm {

struct PicturesReport {
    double denoise_seconds = 0;
    std::uint64_t replaced_pixels = 0;  // not finite, replaced by the denoiser
};

// Tries all of them, so that one full disk does not cost every picture, and returns the first
// error. Width and height are the whole picture's. With a denoiser, .exr files get another layer
// and other files the denoised picture; if it fails, the rendered one is written nevertheless.
Result<PicturesReport> write_pictures(const std::vector<std::filesystem::path>& paths,
                                      const Film& film, std::uint32_t width, std::uint32_t height,
                                      const FilmRecord& record, const Denoiser* denoiser = nullptr);

}  // namespace hm
