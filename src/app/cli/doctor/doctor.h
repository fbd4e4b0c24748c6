// `himalaya doctor`: what this machine offers, what is missing, and whether its devices draw right.
#pragma once

#include "app/cli/exit_code.h"
#include "app/cli/options.h"

namespace hm::cli {

// The verdict of doctor/report.h.
Result<ExitCode> doctor(const DoctorOptions& options);

}  // namespace hm::cli
