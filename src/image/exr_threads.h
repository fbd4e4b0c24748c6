// OpenEXR compresses and decompresses blocks on a global thread pool. Its default size is zero, so
// everything runs on the calling thread. This library never changes the size; the program may.
#pragma once

namespace hm {

// Threads that OpenEXR may use, including the calling one; 0: all hardware threads. Must not be
// called while a file is read or written.
void set_exr_threads(unsigned threads);

}  // namespace hm
