// All files of a rendering: pictures, and parts where only a range of the samples was drawn.
#pragma once

#include <optional>

#include "app/cli/film_record.h"
#include "app/cli/options.h"
#include "app/cli/report.h"
#include "film/denoise.h"
#include "film/film.h"

namespace hm::cli {

// All are tried, and the first error is returned: it says where the samples are where `kept`, the
// checkpoint, has them. The summary gets what the denoiser says.
Result<void> write_outputs(const RenderOptions& options, const Film& film, const FilmRecord& record,
                           bool kept, const std::optional<Denoiser>& denoiser,
                           RenderSummary& summary);

}  // namespace hm::cli
