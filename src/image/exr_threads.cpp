#include "image/exr_threads.h"

#include <ImfThreading.h>

#include <thread>

namespace hm {

void set_exr_threads(unsigned threads) {
    if (threads == 0) threads = std::thread::hardware_concurrency();
    // The caller of a file with a pool only waits for it.
    Imf::setGlobalThreadCount(threads > 1 ? int(threads) : 0);
}

}  // namespace hm
