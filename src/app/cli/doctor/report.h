// What the doctor says, for people and for programs.
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

// ok: a GPU is there, and every device draws what the CPU draws. warned: pictures can be drawn,
// but something is amiss or only the CPU draws. device_failed: a device drew a wrong picture, or
// none.
ExitCode verdict(const Diagnosis& diagnosis);

std::string doctor_text(const Diagnosis& diagnosis);
std::string doctor_json(const Diagnosis& diagnosis);

}  // namespace hm::cli
