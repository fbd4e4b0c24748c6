#include "session/pictures.h"

#include <utility>

#include "film/layers.h"
#include "film/write.h"
#include "session/denoise_layers.h"

namespace hm {

Result<PicturesReport> write_pictures(const std::vector<std::filesystem::path>& paths,
                                      const Film& film, std::uint32_t width, std::uint32_t height,
                                      const FilmRecord& record, const Denoiser* denoiser) {
    PicturesReport report;
    if (paths.empty()) return report;
    Image picture = film.resolve();
    const SurfaceNames& names = record.names;
    LayeredImage layers =
        film_layers(film, {.width = width,
                           .height = height,
                           .alpha = record.alpha,
                           .half = record.half,
                           .names = {names.objects, names.materials, names.assets}});
    Result<void> outcome;
    if (denoiser != nullptr) {
        Result<Denoised> denoised = denoise_layers(*denoiser, layers, {});
        if (denoised) {
            picture = std::move(denoised->picture);
            report = {denoised->seconds, denoised->replaced_pixels};
        } else {
            outcome = tl::unexpected(std::move(denoised.error()));
        }
    }
    PictureOptions how{
        .crop = film.crop, .alpha = record.alpha, .tone = record.tone, .exr = record.exr};
    if (record.auto_exposure) how.tone.exposure = auto_exposure(picture);
    layers.metadata.insert(layers.metadata.begin(), record.picture.begin(), record.picture.end());
    for (const std::filesystem::path& path : paths) {
        Result<void> written = write_picture(path, picture, layers, how);
        if (!written && outcome) outcome = std::move(written);
    }
    if (!outcome) return tl::unexpected(std::move(outcome.error()));
    return report;
}

}  // namespace hm
