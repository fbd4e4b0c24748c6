// `himalaya doctor`: this machine's devices and drivers, what is missing, and whether devices
// render correctly.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

// The verdict of doctor/report.h.
Result<ExitCode> doctor(const DoctorOptions& options);

}  // namespace hm::cli
