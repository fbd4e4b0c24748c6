#include "session/pictures.h"

#include <utility>

#include "output/layers.h"
#include "output/tonemap.h"
#include "session/denoise_layers.h"

namespace hm {

FinishedPicture finish_picture(const Film& film, std::uint32_t width, std::uint32_t height,
                               const FilmRecord& record, const Denoiser* denoiser) {
    const SurfaceNames& names = record.names;
    FinishedPicture finished{
        .picture = film.resolve(),
        .layers = film_layers(film, {.width = width,
                                     .height = height,
                                     .alpha = record.alpha,
                                     .half = record.half,
                                     .names = {names.objects, names.materials, names.assets},
                                     .origin = record.origin}),
        .options = {
            .crop = film.crop, .alpha = record.alpha, .tone = record.tone, .exr = record.exr}};
    if (denoiser != nullptr) {
        Result<Denoised> denoised = denoise_layers(*denoiser, finished.layers, {});
        if (denoised) {
            finished.picture = std::move(denoised->picture);
            finished.denoise_seconds = denoised->seconds;
            finished.replaced_pixels = denoised->replaced_pixels;
        } else {
            finished.denoised = tl::unexpected(std::move(denoised.error()));
        }
    }
    if (record.auto_exposure) finished.options.tone.exposure = auto_exposure(finished.picture);
    Metadata& metadata = finished.layers.metadata;
    metadata.insert(metadata.begin(), record.picture.begin(), record.picture.end());
    return finished;
}

Result<void> write_pictures(const std::vector<std::filesystem::path>& paths,
                            const FinishedPicture& finished) {
    Result<void> outcome = finished.denoised;
    for (const std::filesystem::path& path : paths) {
        Result<void> written =
            write_picture(path, finished.picture, finished.layers, finished.options);
        if (!written && outcome) outcome = std::move(written);
    }
    return outcome;
}

}  // namespace hm
