// glTF names of the enum values in shading/structs.h: each array is indexed by the enum value.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "shading/structs.h"

namespace hm {

inline constexpr std::array<std::string_view, 3> kAlphaModeNames{"OPAQUE", "MASK", "BLEND"};
static_assert(kAlphaOpaque == 0 && kAlphaMask == 1 && kAlphaBlend == 2);

inline constexpr std::array<std::string_view, 3> kLightKindNames{"directional", "point", "spot"};
static_assert(kLightDirectional == 0 && kLightPoint == 1 && kLightSpot == 2);

inline std::optional<std::uint32_t> find_choice(std::span<const std::string_view> names,
                                                std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return std::uint32_t(found - names.begin());
}

}  // namespace hm
