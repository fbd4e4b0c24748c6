// `himalaya bench`: how fast a device renders scenes, as JSON.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

Result<ExitCode> bench(const BenchOptions& options);

}  // namespace hm::cli
