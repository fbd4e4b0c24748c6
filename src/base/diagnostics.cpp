#include "base/diagnostics.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"

namespace hm {

std::string Warning::line() const {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!location.empty()) text += location + ": ";
    text += message;
    if (count > 1) text += fmt::format(" ({} times)", count);
    return printable(text);
}

void Diagnostics::List::add(Warning warning) {
    // Separated by a zero byte, which no path contains.
    const auto [found, is_new] =
        index.try_emplace(warning.file + '\0' + warning.message, all.size());
    if (is_new)
        all.push_back(std::move(warning));
    else
        all[found->second].count += warning.count;
}

}  // namespace hm
