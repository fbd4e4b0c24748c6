// Containers of glTF: GLB, and bytes encoded as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hm::corpus {

inline constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
inline constexpr std::uint32_t kBinaryChunk = 0x004e4942;

std::string chunk(std::uint32_t type, std::string_view content, char filler);
std::string glb_header(std::uint32_t version, std::size_t length);
std::string make_glb(std::string_view json, std::string_view binary);

// Little-endian.
std::string word(std::size_t value);

std::string base64(std::string_view bytes);
std::string data_uri(std::string_view bytes,
                     std::string_view media_type = "application/octet-stream");

// A PNG image of one pixel.
std::string tiny_png();

}  // namespace hm::corpus
