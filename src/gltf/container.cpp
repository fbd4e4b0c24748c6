#include "gltf/container.h"

#include <fmt/format.h>

#include <cstdint>

namespace hm::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;        // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN\0"
constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

tl::unexpected<Error> invalid_glb(const std::string& file, std::size_t at, std::string message) {
    return fail(ErrorKind::invalid, file, fmt::format("byte {}", at), std::move(message));
}

// The bytes of the container, as long as its header says.
Result<std::span<const std::byte>> check_header(std::span<const std::byte> bytes,
                                                const std::string& file, Diagnostics& diagnostics) {
    if (bytes.size() < kHeaderSize)
        return invalid_glb(file, bytes.size(), "the GLB header is truncated");
    const std::uint32_t version = little_endian(bytes, 4);
    if (version != 2)
        return fail(ErrorKind::unsupported, file, "byte 4",
                    fmt::format("GLB version {} is not supported, only 2", version));
    const std::uint32_t length = little_endian(bytes, 8);
    if (length > bytes.size())
        return invalid_glb(file, 8,
                           fmt::format("the GLB header gives a length of {} bytes, the file has {}",
                                       length, bytes.size()));
    if (length < kHeaderSize)
        return invalid_glb(
            file, 8,
            fmt::format("the GLB header gives a length of {} bytes, less than its size", length));
    if (length < bytes.size())
        diagnostics.warn(file, fmt::format("byte {}", length), "bytes after the end of the GLB");
    return bytes.first(length);
}

}  // namespace

Result<Container> split_container(std::span<const std::byte> bytes, const std::string& file,
                                  Diagnostics& diagnostics) {
    if (bytes.size() < 4 || little_endian(bytes, 0) != kMagic) return Container{bytes, {}};
    HM_TRY_ASSIGN(bytes, check_header(bytes, file, diagnostics));

    Container parts;
    std::size_t at = kHeaderSize;
    for (std::size_t number = 0; at < bytes.size(); ++number) {
        if (bytes.size() - at < kChunkHeaderSize)
            return invalid_glb(file, at, "a GLB chunk header is truncated");
        const std::size_t length = little_endian(bytes, at);
        const std::uint32_t type = little_endian(bytes, at + 4);
        if (length > bytes.size() - at - kChunkHeaderSize)
            return invalid_glb(file, at,
                               fmt::format("a GLB chunk of {} bytes extends past the end", length));
        if (length % 4 != 0)
            return invalid_glb(
                file, at,
                fmt::format("the length of a GLB chunk, {}, is not a multiple of 4", length));
        const auto content = bytes.subspan(at + kChunkHeaderSize, length);
        if (number == 0 && type != kJsonChunk)
            return invalid_glb(file, at, "the first GLB chunk is not JSON");
        if (number == 0) {
            parts.json = content;
        } else if (number == 1 && type == kBinaryChunk) {
            parts.binary = content;
        } else {
            diagnostics.warn(file, fmt::format("byte {}", at),
                             "GLB chunk of unknown type, skipped");
        }
        at += kChunkHeaderSize + length;
    }
    if (parts.json.empty()) return invalid_glb(file, at, "the GLB has no JSON chunk");
    return parts;
}

}  // namespace hm::gltf
