// The finished pictures of a film and its record: those of a rendering and those of its merged
// parts are the same.
#pragma once

#include <filesystem>
#include <vector>

#include "denoise/denoise.h"
#include "film/film.h"
#include "output/write.h"
#include "session/film_record.h"

namespace hm {

// A picture with its layers, ready to be written.
struct FinishedPicture {
    FloatImage picture;  // denoised if that was asked for, else the beauty
    LayeredImage layers;
    PictureOptions options;
    double denoise_seconds = 0;
    std::uint64_t replaced_pixels = 0;  // not finite, replaced by the denoiser
    Result<void> denoised{};            // if it failed, `picture` is the rendered one
};

// Width and height are the whole picture's. `denoiser` may be null; with one the layers get
// "denoised".
FinishedPicture finish_picture(const Film& film, std::uint32_t width, std::uint32_t height,
                               const FilmRecord& record, const Denoiser* denoiser = nullptr);

// Tries all of them, so that one full disk does not cost every picture, and returns the first
// error, which may be the denoiser's.
Result<void> write_pictures(const std::vector<std::filesystem::path>& paths,
                            const FinishedPicture& finished);

}  // namespace hm
