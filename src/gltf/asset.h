// Checks that a file can be read: its glTF version and the extensions it requires.
#pragma once

#include <string_view>

#include "gltf/document.h"
#include "gltf/source.h"

namespace hm::gltf {

// The glTF Transform command that converts images of any format to PNG.
inline constexpr std::string_view kPicturesToPng = "gltf-transform png IN OUT --formats '*'";

// Whether this program implements the extension.
bool is_supported(std::string_view extension);

Result<void> check_asset(const Json& root);

// asset.generator, empty if absent.
Result<std::string> generator_of(const Json& root);

// Fails if the file requires an unsupported extension; warns of unsupported ones it only uses.
Result<void> check_extensions(const JsonDocument& document, Source& source);

}  // namespace hm::gltf
