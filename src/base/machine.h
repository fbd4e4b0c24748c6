// The machine that this runs on, and the build that runs: for reports.
#pragma once

#include <string>

#include "base/json_writer.h"

namespace hm {

std::string cpu_model();     // "AMD EPYC 9654 96-Core Processor", or "unknown"
unsigned cpu_threads();      // those that this process may use
std::string build_commit();  // "62a7270", "62a7270-dirty" or "unknown"

// "cpu", "threads", "commit" and "compiler": what every benchmark's JSON object begins with.
void write_machine(JsonWriter& json);

// Wall-clock seconds from an arbitrary start.
double wall_seconds();
// Processor seconds that all threads of this process have used.
double processor_seconds();

}  // namespace hm
