// KHR_materials_variants: other materials for the same primitives, chosen by name.
#pragma once

#include <optional>

#include "gltf/json.h"
#include "gltf/source.h"

namespace hm::gltf {

// Fills source.variant_count and, from the options, source.variant. A name that the file does not
// have is ErrorKind::invalid_argument.
Result<void> choose_variant(const Json& root, Source& source);

// A primitive's material, of the chosen variant where that has one for it.
Result<std::optional<std::size_t>> read_material_index(const Json& primitive, const Source& source,
                                                       std::size_t material_count);

}  // namespace hm::gltf
