// libFuzzer: any bytes as an environment, Radiance HDR or OpenEXR.
#include "fuzz_picture.h"
#include "image/read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    hm::fuzz::check_picture(hm::read_environment_image(hm::fuzz::bytes_of(data, size), "fuzzed"));
    return 0;
}
