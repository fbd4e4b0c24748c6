// Ctrl-C, SIGTERM and the end of the terminal: the first signal requests an early stop, the second
// exits at once.
#pragma once

namespace hm::cli {

// From now on signals are counted instead of terminating the program.
void catch_interrupts();
bool interrupted();

// Writing to a closed pipe or past a file size limit becomes an error of the write, instead of
// terminating the program.
void ignore_write_signals();

}  // namespace hm::cli
