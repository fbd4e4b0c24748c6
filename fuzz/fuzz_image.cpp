// libFuzzer: any bytes as a texture, PNG or JPEG. A changed PNG would nearly always fail at a
// chunk's checksum and show nothing of the decoder, so the mutator mostly repairs those.
#include <zlib.h>

#include <algorithm>
#include <array>

#include "fuzz_picture.h"
#include "image/decoded_size.h"
#include "image/read.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Data = std::span<std::uint8_t>;

std::uint32_t big_endian(Data at) {
    return std::uint32_t(at[0]) << 24 | std::uint32_t(at[1]) << 16 | std::uint32_t(at[2]) << 8 |
           at[3];
}

// A chunk is its length, four letters, so many bytes, and the checksum of letters and bytes.
void repair_png(Data file) {
    constexpr std::array<std::uint8_t, 4> kSignature{0x89, 'P', 'N', 'G'};
    constexpr std::size_t kHeader = 8, kChecksum = 4;
    if (file.size() < kHeader || !std::equal(kSignature.begin(), kSignature.end(), file.begin()))
        return;
    Data rest = file.subspan(8);
    while (rest.size() >= kHeader + kChecksum) {
        const std::size_t length = big_endian(rest);
        if (length > rest.size() - kHeader - kChecksum) return;
        const Data sum = rest.subspan(kHeader + length, kChecksum);
        const auto crc = std::uint32_t(crc32(0, &rest[4], uInt(4 + length)));
        for (std::size_t i = 0; i < kChecksum; ++i)
            sum[i] = std::uint8_t(crc >> (24 - 8 * i));
        rest = rest.subspan(kHeader + length + kChecksum);
    }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
    size = LLVMFuzzerMutate(data, size, max_size);
    if (seed % 8 != 0) repair_png({data, size});
    return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = hm::fuzz::bytes_of(data, size);
    hm::ReadWarnings warnings;
    const auto image = hm::read_texture_image(bytes, "fuzzed", warnings);
    if (!image) {
        HM_CHECK(!image.error().message.empty(), "an error says why");
        return 0;
    }
    std::visit([](const auto& stored) { hm::fuzz::check_picture(stored); }, image->image());
    // The loader relies on the header's size to keep within its memory limit.
    HM_CHECK(hm::decoded_size(bytes) == image->bytes().size(), "the size is known beforehand");
    return 0;
}
