// Text from files before it reaches a terminal.
#pragma once

#include <string>
#include <string_view>

namespace hm {

// Control characters (C0, DEL, C1) and bytes that are not UTF-8 become \xNN.
std::string printable(std::string_view text);

}  // namespace hm
