#include "session/outputs.h"

#include <utility>
#include <vector>

#include "output/write.h"
#include "session/checkpoint.h"
#include "session/pictures.h"

namespace hm {

Result<void> write_outputs(std::span<const std::filesystem::path> outputs,
                           const RenderSettings& settings, const Film& film,
                           const FilmRecord& record, const Denoiser* denoiser,
                           RenderSummary& summary) {
    const FrameSettings& frame = settings.frame;
    std::vector<std::filesystem::path> pictures;
    Result<void> outcome;
    for (const std::filesystem::path& path : outputs) {
        // The .exr files of a range of the samples are parts.
        const bool is_part = settings.sampling.range && picture_kind(path) == PictureKind::exr;
        if (!is_part) pictures.push_back(path);
        Result<void> written = is_part ? write_part(path, frame, film, record) : Result<void>();
        if (!written && outcome) outcome = std::move(written);
    }
    if (pictures.empty()) return outcome;
    const FinishedPicture finished =
        finish_picture(film, frame.width, frame.height, record, denoiser);
    Result<void> written = write_pictures(pictures, finished);
    if (!written && outcome) outcome = std::move(written);
    if (denoiser != nullptr) summary.denoiser = denoiser->description();
    summary.times.denoise = finished.denoise_seconds;
    summary.replaced_pixels = finished.replaced_pixels;
    return outcome;
}

}  // namespace hm
