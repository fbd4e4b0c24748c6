// OpenEXR compresses and decompresses blocks on a thread pool that the process has once. It is
// empty, and everything runs on the calling thread, until somebody sets its size. The library never
// does; the program may, from its number of threads.
#pragma once

namespace hm {

// How many threads OpenEXR may use for one file, the calling one included; 0: as many as the
// machine has. Not while a file is read or written.
void set_exr_threads(unsigned threads);

}  // namespace hm
