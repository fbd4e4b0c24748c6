// Where a glTF file's buffers and images come from: data URIs (RFC 2397) and relative paths.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/memory.h"

namespace hm::gltf {

// Errors are the message alone; callers know the file and the pointer.
template <class T>
using UriResult = tl::expected<T, std::string>;

bool is_data_uri(std::string_view uri);

// The bytes of a base64 data URI. Strict: no white space, padding as RFC 4648 has it.
UriResult<ByteArray> decode_data_uri(std::string_view uri);

// The media type of a data URI, as written; empty where there is none.
std::string_view media_type(std::string_view data_uri);

// A percent-decoded path. Schemes of the network are always refused; what could lead out of the
// glTF file's folder ("..", absolute paths, "file:", backslashes) unless `allow_external`.
UriResult<std::filesystem::path> decode_path(std::string_view uri, bool allow_external = false);

// Fails where symbolic links lead `path` out of `folder`.
UriResult<void> check_inside(const std::filesystem::path& path,
                             const std::filesystem::path& folder);

}  // namespace hm::gltf
