// Where a glTF file's buffers and images come from: data URIs (RFC 2397) and relative paths.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace hm::gltf {

// Errors are the message alone; callers know the file and the place.
template <class T>
using UriResult = tl::expected<T, std::string>;

bool is_data_uri(std::string_view uri);

// The bytes of a base64 data URI. Strict: no white space, padding as RFC 4648 has it.
UriResult<std::vector<std::byte>> decode_data_uri(std::string_view uri);

// A percent-decoded path below the glTF file's folder. What could lead out of it is refused: "..",
// absolute paths and schemes.
UriResult<std::filesystem::path> decode_path(std::string_view uri);

}  // namespace hm::gltf
