// The doctor's report, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "app/cli/doctor/checks.h"
#include "app/cli/doctor/trial.h"
#include "app/cli/exit_code.h"

namespace hm::cli {

struct Diagnosis {
    Machine machine;
    std::vector<Finding> findings;
    std::vector<Trial> trials;
};

// ok: there is a GPU, and every device renders what the CPU renders. warned: rendering works, but
// there are warnings or only the CPU renders. device_failed: a device rendered a wrong picture or
// none.
ExitCode verdict(const Diagnosis& diagnosis);

std::string doctor_text(const Diagnosis& diagnosis);
std::string doctor_json(const Diagnosis& diagnosis);

}  // namespace hm::cli
