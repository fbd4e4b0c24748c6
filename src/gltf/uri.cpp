#include "gltf/uri.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <system_error>

namespace hm::gltf {
namespace {

int base64_value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

int hex_value(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

bool equal_ignoring_case(std::string_view text, std::string_view lower) {
    if (text.size() != lower.size()) return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if ((c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c) != lower[i]) return false;
    }
    return true;
}

// RFC 3986: a letter, then letters, digits, "+", "-" and ".", then a colon.
bool has_scheme(std::string_view uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string_view::npos || colon == 0) return false;
    for (std::size_t i = 0; i < colon; ++i) {
        const char c = uri[i];
        const bool letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        const bool other = (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
        if (!letter && !(other && i > 0)) return false;
    }
    return true;
}

tl::unexpected<std::string> refuse(const char* message) {
    return tl::unexpected<std::string>(message);
}

UriResult<ByteArray> decode_base64(std::string_view text) {
    if (text.size() % 4 != 0) return refuse("base64 length is not a multiple of 4");
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=')
        ++padding;
    ByteArray bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t group = 0;
    const std::size_t digits = text.size() - padding;
    for (std::size_t i = 0; i < digits; ++i) {
        const int value = base64_value(text[i]);
        if (value < 0) return refuse("invalid base64 character");
        group = (group << 6 | std::uint32_t(value)) & 0xffffffu;
        // Each digit after the first of four completes a byte.
        if (i % 4 != 0) bytes.push_back(std::byte(group >> (6 - i % 4 * 2)));
    }
    const std::uint32_t unused = padding == 2 ? 0xfu : padding == 1 ? 0x3u : 0u;
    if ((group & unused) != 0) return refuse("base64 has nonzero padding bits");
    return bytes;
}

UriResult<std::string> decode_percent(std::string_view text) {
    std::string decoded;
    decoded.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        const int high = i + 2 < text.size() ? hex_value(text[i + 1]) : -1;
        const int low = i + 2 < text.size() ? hex_value(text[i + 2]) : -1;
        if (high < 0 || low < 0) return refuse("\"%\" is not followed by two hexadecimal digits");
        decoded += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return decoded;
}

UriResult<ByteArray> decode_percent_bytes(std::string_view text) {
    const auto decoded = decode_percent(text);
    if (!decoded) return tl::unexpected(decoded.error());
    const auto* first = reinterpret_cast<const std::byte*>(decoded->data());
    return ByteArray(first, first + decoded->size());
}

}  // namespace

bool is_data_uri(std::string_view uri) {
    return equal_ignoring_case(uri.substr(0, 5), "data:");
}

UriResult<ByteArray> decode_data_uri(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) return refuse("data URI without a comma");
    constexpr std::string_view kMarker = ";base64";
    const std::string_view header = uri.substr(0, comma);
    const std::string_view data = uri.substr(comma + 1);
    const bool is_base64 =
        header.size() >= kMarker.size() &&
        equal_ignoring_case(header.substr(header.size() - kMarker.size()), kMarker);
    auto bytes = is_base64 ? decode_base64(data) : decode_percent_bytes(data);
    if (!bytes) return tl::unexpected<std::string>("data URI: " + bytes.error());
    return bytes;
}

std::string_view media_type(std::string_view data_uri) {
    constexpr std::size_t kScheme = 5;
    const std::size_t end = data_uri.find_first_of(";,", kScheme);
    return data_uri.substr(kScheme, end == std::string_view::npos ? 0 : end - kScheme);
}

UriResult<std::filesystem::path> decode_path(std::string_view uri, bool allow_external) {
    if (uri.empty()) return refuse("empty URI");
    constexpr std::string_view kFile = "file:";
    const bool is_file = equal_ignoring_case(uri.substr(0, kFile.size()), kFile);
    if (is_file && allow_external) {
        uri.remove_prefix(kFile.size());
        if (uri.starts_with("//")) uri.remove_prefix(2);
        if (!uri.starts_with('/')) return refuse("file URIs of other machines are not supported");
    } else if (has_scheme(uri)) {
        return refuse("only relative paths and data URIs are supported");
    }
    auto decoded = decode_percent(uri);
    if (!decoded) return tl::unexpected(std::move(decoded.error()));
    if (decoded->find('\0') != std::string::npos) return refuse("the path contains a zero byte");
    std::filesystem::path path(*decoded);
    if (allow_external) return path;
    // Backslash is a path separator on Windows; files must behave the same everywhere.
    if (decoded->find('\\') != std::string::npos) return refuse("paths with \"\\\" are rejected");
    if (path.has_root_path())
        return refuse("absolute paths are rejected (allow-external permits them)");
    for (const auto& part : path)
        if (part == "..")
            return refuse(
                "paths with \"..\" are rejected: they leave the file's folder (allow-external "
                "permits them)");
    return path;
}

UriResult<void> check_inside(const std::filesystem::path& path,
                             const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::error_code error;
    // Absolute first: weakly_canonical leaves the relative path of a missing file relative.
    const fs::path root =
        fs::weakly_canonical(fs::absolute(folder.empty() ? fs::path(".") : folder), error);
    if (error) return tl::unexpected(error.message());
    const fs::path real = fs::weakly_canonical(fs::absolute(path), error);
    if (error) return tl::unexpected(error.message());
    const auto [left, unused] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
    if (left != root.end())
        return refuse("a symbolic link leaves the file's folder (allow-external permits it)");
    return {};
}

}  // namespace hm::gltf
