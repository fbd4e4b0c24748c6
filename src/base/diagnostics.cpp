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

void Diagnostics::warn(std::string file, std::string location, std::string message,
                       std::size_t count) {
    // Separated by a zero byte, which no path contains.
    const auto [found, is_new] = index_.try_emplace(file + '\0' + message, warnings_.size());
    if (is_new) {
        warnings_.push_back({std::move(file), std::move(location), std::move(message), count});
    } else {
        warnings_[found->second].count += count;
    }
}

}  // namespace hm
