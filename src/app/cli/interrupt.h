// Ctrl-C and SIGTERM: the first asks for an early end, the second ends the program at once.
#pragma once

namespace hm::cli {

// From now on signals are counted instead of ending the program.
void catch_interrupts();
bool interrupted();

}  // namespace hm::cli
