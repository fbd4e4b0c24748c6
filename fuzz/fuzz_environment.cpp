// libFuzzer: any bytes as an environment, Radiance HDR or OpenEXR.
#include <cmath>

#include "fuzz_picture.h"
#include "image/read.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    hm::ReadWarnings warnings;
    const auto image =
        hm::read_environment_image(hm::fuzz::bytes_of(data, size), "fuzzed", warnings);
    if (!image) {
        HM_CHECK(!image.error().message.empty(), "an error says why");
        return 0;
    }
    hm::fuzz::check_picture(*image);
    for (const auto& pixel : image->pixels)
        for (const float value : pixel)
            HM_CHECK(std::isfinite(value) && value >= 0, "a radiance is finite and not negative");
    return 0;
}
