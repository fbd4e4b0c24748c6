#include "app/cli/pictures.h"

#include <utility>

#include "film/layers.h"
#include "film/write.h"

namespace hm::cli {

Result<void> write_pictures(const std::vector<std::filesystem::path>& paths, const Film& film,
                            std::uint32_t width, std::uint32_t height, const FilmRecord& record) {
    if (paths.empty()) return {};
    const Image picture = film.resolve();
    PictureOptions how{
        .crop = film.crop, .alpha = record.alpha, .tone = record.tone, .exr = record.exr};
    if (record.auto_exposure) how.tone.exposure = auto_exposure(picture);
    const SurfaceNames& names = record.names;
    LayeredImage layers =
        film_layers(film, {.width = width,
                           .height = height,
                           .alpha = record.alpha,
                           .half = record.half,
                           .names = {names.objects, names.materials, names.assets}});
    layers.metadata.insert(layers.metadata.begin(), record.picture.begin(), record.picture.end());
    Result<void> outcome;
    for (const std::filesystem::path& path : paths) {
        Result<void> written = write_picture(path, picture, layers, how);
        if (!written && outcome) outcome = std::move(written);
    }
    return outcome;
}

}  // namespace hm::cli
