#include "app/cli/help.h"

#include <CLI/CLI.hpp>
#include <string_view>

namespace hm::cli {
namespace {

constexpr std::size_t kFlagColumn = 30;
constexpr std::size_t kTextColumn = 68;

std::string wrap(std::string_view text, std::size_t width) {
    std::string out;
    while (text.size() > width) {
        std::size_t space = text.rfind(' ', width);
        if (space == text.npos || space == 0) space = width;
        out.append(text.substr(0, space)).append("\n");
        text.remove_prefix(space);
        if (text.starts_with(' ')) text.remove_prefix(1);
    }
    return out.append(text);
}

}  // namespace

HelpFormatter::HelpFormatter() {
    column_width(kFlagColumn);
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
    // A positional's name says enough.
    if (option->get_positional() || option->get_type_name().empty()) return "";
    return " " + option->get_type_name();
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    return wrap(option->get_description(), kTextColumn);
}

}  // namespace hm::cli
