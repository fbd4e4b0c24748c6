#include "app/cli/outputs.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "app/cli/checkpoint.h"
#include "app/cli/pictures.h"
#include "film/write.h"

namespace hm::cli {
namespace {

// Of a range of the samples, .exr files are parts. All are tried, and the first error is returned.
Result<void> write_all(const RenderOptions& options, const Film& film, const FilmRecord& record,
                       const std::optional<Denoiser>& denoiser, RenderSummary& summary) {
    std::vector<std::filesystem::path> pictures;
    Result<void> outcome;
    for (const std::filesystem::path& path : options.outputs) {
        const bool is_part = options.keep.samples && picture_kind(path) == PictureKind::exr;
        if (!is_part) pictures.push_back(path);
        Result<void> written = is_part ? write_part(path, options, film, record) : Result<void>();
        if (!written && outcome) outcome = std::move(written);
    }
    const Result<PicturesReport> written = write_pictures(
        pictures, film, options.width, options.height, record, denoiser ? &*denoiser : nullptr);
    if (!written) return outcome ? tl::unexpected(written.error()) : outcome;
    if (denoiser) summary.denoiser = denoiser->description();
    summary.times.denoise = written->denoise_seconds;
    summary.replaced_pixels = written->replaced_pixels;
    return outcome;
}

}  // namespace

Result<void> write_outputs(const RenderOptions& options, const Film& film, const FilmRecord& record,
                           bool kept, const std::optional<Denoiser>& denoiser,
                           RenderSummary& summary) {
    Result<void> written = write_all(options, film, record, denoiser, summary);
    if (!written && !options.keep.checkpoint.empty() && kept)
        written.error().message +=
            fmt::format("; the samples are kept in {}, --resume writes again",
                        options.keep.checkpoint.string());
    return written;
}

}  // namespace hm::cli
