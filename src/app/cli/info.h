// `himalaya info`: the contents of a scene file, and which of them are supported.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

// ok, warned if there were warnings, or the error that would prevent rendering. What is known about
// a refused file is printed nevertheless.
Result<ExitCode> info(const InfoOptions& options);

}  // namespace hm::cli
