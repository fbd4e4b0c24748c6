// URIs of buffers and images: data URIs (RFC 2397) and relative paths.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "base/memory.h"

namespace hm::gltf {

// Errors are messages only; callers add the file and the JSON pointer.
template <class T>
using UriResult = tl::expected<T, std::string>;

bool is_data_uri(std::string_view uri);

// The bytes of a data URI, base64 or percent-encoded. Strict base64: no white space, padding as in
// RFC 4648.
UriResult<ByteArray> decode_data_uri(std::string_view uri);

// The media type of a data URI, as written; empty if absent.
std::string_view media_type(std::string_view data_uri);

// A percent-decoded path. Network schemes are always rejected; anything that could leave the glTF
// file's folder ("..", absolute paths, "file:", backslashes) is rejected unless `allow_external`.
UriResult<std::filesystem::path> decode_path(std::string_view uri, bool allow_external = false);

// Fails if symbolic links make `path` leave `folder`.
UriResult<void> check_inside(const std::filesystem::path& path,
                             const std::filesystem::path& folder);

}  // namespace hm::gltf
