// Whether this file is one for us: glTF's version and the extensions it asks for.
#pragma once

#include <string_view>

#include "gltf/document.h"
#include "gltf/source.h"

namespace hm::gltf {

// The command of glTF Transform that turns pictures of every format into PNG.
inline constexpr std::string_view kPicturesToPng = "gltf-transform png IN OUT --formats '*'";

// Whether this program evaluates the extension.
bool is_supported(std::string_view extension);

Result<void> check_asset(const Json& root);

// Fails if the file requires an extension that is not supported, warns of those it merely uses.
Result<void> check_extensions(const JsonDocument& document, Source& source);

}  // namespace hm::gltf
