// The machine that this runs on, and the build that runs: for reports. Every benchmark's JSON
// begins with it.
#pragma once

#include <string>

namespace hm {

std::string cpu_model();     // "AMD EPYC 9654 96-Core Processor", or "unknown"
unsigned cpu_threads();      // those that this process may use
std::string build_commit();  // "62a7270", "62a7270-dirty" or "unknown"

// "cpu": ..., "threads": ..., "commit": ..., "compiler": ... as the members of a JSON object, no
// braces.
std::string machine_json();

// Wall-clock seconds from an arbitrary start.
double wall_seconds();
// Processor seconds that all threads of this process have used.
double processor_seconds();

}  // namespace hm
