// Text for display.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hm {

// Escapes control characters (C0, DEL, C1), line separators, bidirectional controls and bytes that
// are not valid UTF-8 as \xNN.
std::string printable(std::string_view text);

// Text of a file as part of a message: quoted and cut to a length that fits a line.
std::string excerpt(std::string_view text);

// Joins the parts: "a, b, c" with ", " as the separator.
std::string joined(const std::vector<std::string>& parts, std::string_view separator);

}  // namespace hm
