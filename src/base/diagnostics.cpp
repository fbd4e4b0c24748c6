#include "base/diagnostics.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"

namespace hm {

std::string Warning::line() const {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!place.empty()) text += place + ": ";
    text += message;
    if (count > 1) text += fmt::format(" ({} times)", count);
    return printable(text);
}

void Diagnostics::warn(std::string file, std::string place, std::string message,
                       std::size_t count) {
    // A zero byte parts the two: no path has one.
    const auto [found, is_new] = index_.try_emplace(file + '\0' + message, warnings_.size());
    if (is_new) {
        warnings_.push_back({std::move(file), std::move(place), std::move(message), count});
    } else {
        warnings_[found->second].count += count;
    }
}

}  // namespace hm
