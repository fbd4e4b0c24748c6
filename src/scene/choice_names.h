// How glTF names or numbers the enum values in shading/structs.h: each array is indexed by the enum
// value.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "shading/structs.h"

namespace hm {

inline constexpr std::array<std::string_view, 3> kAlphaModeNames{"OPAQUE", "MASK", "BLEND"};
static_assert(kAlphaOpaque == 0 && kAlphaMask == 1 && kAlphaBlend == 2);

inline constexpr std::array<std::string_view, 3> kLightKindNames{"directional", "point", "spot"};
static_assert(kLightDirectional == 0 && kLightPoint == 1 && kLightSpot == 2);

inline constexpr std::array<std::uint64_t, 3> kWrapCodes{10497, 33071, 33648};
static_assert(kWrapRepeat == 0 && kWrapClamp == 1 && kWrapMirror == 2);

inline constexpr std::array<std::uint64_t, 2> kFilterCodes{9729, 9728};
static_assert(kFilterLinear == 0 && kFilterNearest == 1);

template <class T, std::size_t N>
std::optional<std::uint32_t> find_choice(const std::array<T, N>& choices, const T& wanted) {
    const auto found = std::find(choices.begin(), choices.end(), wanted);
    if (found == choices.end()) return std::nullopt;
    return std::uint32_t(found - choices.begin());
}

}  // namespace hm
