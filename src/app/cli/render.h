// `himalaya render`: a scene file to pictures.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

// ok, or interrupted if a signal stopped it early and the samples so far were written.
Result<ExitCode> render(const RenderOptions& options);

}  // namespace hm::cli
