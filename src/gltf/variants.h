// KHR_materials_variants: alternative materials of primitives, chosen by name.
#pragma once

#include <optional>

#include "gltf/json.h"
#include "gltf/source.h"

namespace hm::gltf {

// Sets source.variant_count and, from the options, source.variant. An unknown name is
// ErrorKind::invalid_argument.
Result<void> choose_variant(const Json& root, Source& source);

// A primitive's material; the chosen variant's, if it maps this primitive.
Result<std::optional<std::size_t>> read_material_index(const Json& primitive, const Source& source,
                                                       std::size_t material_count);

}  // namespace hm::gltf
