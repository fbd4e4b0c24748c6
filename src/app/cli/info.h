// `himalaya info`: what is in a scene file, and what of it this program draws.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

// ok, warned where something was warned of, or the error with which the file would not render.
// What is known of a refused file is printed all the same.
Result<ExitCode> info(const InfoOptions& options);

}  // namespace hm::cli
