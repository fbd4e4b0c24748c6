// Where and what a benchmark ran: every bench's JSON begins with it.
#pragma once

#include <string>

namespace hm {

// "cpu": ..., "threads": ..., "commit": ..., "compiler": ... as the members of a JSON object, no
// braces.
std::string machine_json();

// Wall-clock seconds from an arbitrary start.
double wall_seconds();
// Processor seconds that all threads of this process have used.
double processor_seconds();

}  // namespace hm
