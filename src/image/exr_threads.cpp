#include "image/exr_threads.h"

#include <ImfThreading.h>

#include <thread>

namespace hm {

void set_exr_threads(unsigned threads) {
    if (threads == 0) threads = std::thread::hardware_concurrency();
    // With a pool, the calling thread only waits.
    Imf::setGlobalThreadCount(threads > 1 ? int(threads) : 0);
}

}  // namespace hm
