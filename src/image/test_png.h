// Builds PNG chunks, for deliberately damaged or unusual files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "image/codecs.h"

namespace hm::testing_images {

inline Image8 gradient(std::uint32_t width, std::uint32_t height) {
    Image8 image(width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            image.pixels[i][c] = std::uint8_t((4 * i + c) * 7 % 251);
    return image;
}

// The CRC of a chunk, as defined in the standard's annex.
inline std::uint32_t checksum(Bytes bytes) {
    std::uint32_t sum = 0xFFFFFFFFu;
    for (const std::byte b : bytes) {
        sum ^= std::to_integer<std::uint32_t>(b);
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum >> 1) ^ (sum & 1u ? 0xEDB88320u : 0u);
    }
    return ~sum;
}

inline void append_number(std::vector<std::byte>& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(std::byte(value >> shift & 255));
}

inline std::vector<std::byte> make_chunk(std::string_view type,
                                         const std::vector<std::byte>& data) {
    std::vector<std::byte> bytes;
    append_number(bytes, std::uint32_t(data.size()));
    for (const char c : type)
        bytes.push_back(std::byte(c));
    bytes.insert(bytes.end(), data.begin(), data.end());
    append_number(bytes, checksum(Bytes(bytes).subspan(4)));
    return bytes;
}

}  // namespace hm::testing_images
