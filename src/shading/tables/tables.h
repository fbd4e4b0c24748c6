// The constant tables of the shading core as C++ arrays; a GPU uploads the same. The .inl files are
// written by the programs in tools/ that their first lines name.
#pragma once

#include <array>
#include <cstdint>

#include "shading/structs.h"

namespace hm {

struct ShadingTables {
#define HM_CONSTANT_TABLE(number, Type, name, rows) std::array<Type, rows> name;
#include "shading/tables.inl"
};

const ShadingTables& shading_tables();

enum class PixelFilter { box, gaussian, blackman_harris };

// The inverse of the filter's distribution over [-1, 1] of half its width, for 257 even steps of
// [0, 1]: what filter_table holds. Widths are in pixels; a Gaussian's sigma is a fourth of its
// width.
std::array<float, 257> make_filter_table(PixelFilter filter);

}  // namespace hm
