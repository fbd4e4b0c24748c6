// Text for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hm {

// Control characters (C0, DEL, C1), marks that reorder a line and bytes that are no UTF-8: \xNN.
std::string printable(std::string_view text);

// "a, b, c" with ", " as separator.
std::string joined(const std::vector<std::string>& parts, std::string_view separator);

}  // namespace hm
