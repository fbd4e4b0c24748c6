#include "corpus/container.h"

#include "corpus/bases.h"

namespace hm::corpus {

std::string word(std::size_t value) {
    return words({static_cast<std::uint32_t>(value)});
}

std::string chunk(std::uint32_t type, std::string_view content, char filler) {
    std::string padded(content);
    padded.resize((padded.size() + 3) / 4 * 4, filler);
    return word(padded.size()) + word(type) + padded;
}

std::string glb_header(std::uint32_t version, std::size_t length) {
    return "glTF" + word(version) + word(length);
}

std::string make_glb(std::string_view json, std::string_view binary) {
    std::string chunks = chunk(kJsonChunk, json, ' ');
    if (!binary.empty()) chunks += chunk(kBinaryChunk, binary, '\0');
    return glb_header(2, 12 + chunks.size()) + chunks;
}

std::string base64(std::string_view bytes) {
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group =
                group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

std::string data_uri(std::string_view bytes, std::string_view media_type) {
    return "data:" + std::string(media_type) + ";base64," + base64(bytes);
}

std::string tiny_png() {
    static constexpr unsigned char kBytes[] = {
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x06, 0x00, 0x00,
        0x00, 0x1f, 0x15, 0xc4, 0x89, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x44, 0x41, 0x54, 0x78,
        0x9c, 0x63, 0xe0, 0x12, 0x91, 0xd3, 0x00, 0x00, 0x00, 0xcd, 0x00, 0x65, 0x6a, 0x99,
        0x84, 0x42, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
    };
    return {reinterpret_cast<const char*>(kBytes), sizeof kBytes};
}

}  // namespace hm::corpus
