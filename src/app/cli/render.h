// `himalaya render`: a scene file to pictures.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

// ok, or interrupted where a signal ended it early and what was there is written.
Result<ExitCode> render(const RenderOptions& options);

}  // namespace hm::cli
