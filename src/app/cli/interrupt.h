// Ctrl-C, SIGTERM and the end of the terminal: the first asks for an early end, the second ends the
// program at once.
#pragma once

namespace hm::cli {

// From now on signals are counted instead of ending the program.
void catch_interrupts();
bool interrupted();

// Writing to a closed pipe or past a limit on file sizes becomes an error of the write, instead of
// the end of the program and of all that it has in memory.
void ignore_write_signals();

}  // namespace hm::cli
