// All files of a rendering: pictures, and parts if only a range of the samples was drawn.
#pragma once

#include <filesystem>
#include <span>

#include "denoise/denoise.h"
#include "film/film.h"
#include "session/film_record.h"
#include "session/settings.h"
#include "session/summary.h"

namespace hm {

// Tries all of them and returns the first error. The summary gets the denoiser's facts. `denoiser`
// may be null.
Result<void> write_outputs(std::span<const std::filesystem::path> outputs,
                           const RenderSettings& settings, const Film& film,
                           const FilmRecord& record, const Denoiser* denoiser,
                           RenderSummary& summary);

}  // namespace hm
