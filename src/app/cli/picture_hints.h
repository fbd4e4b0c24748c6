// Hints about a finished picture that shows too little: which flag helps.
#pragma once

#include <optional>
#include <string>

#include "app/cli/options.h"
#include "film/film.h"
#include "session/summary.h"

namespace hm::cli {

// One line if no camera ray hit the scene, if the picture is black, or if most of its pixels clip
// or are black in a PNG file; else nothing. A sequence gets a hint for its first frame only.
std::optional<std::string> picture_hint(const RenderOptions& options, const RenderSummary& summary,
                                        const Film& film);

}  // namespace hm::cli
