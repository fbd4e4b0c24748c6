#include "app/cli/hints.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace hm::cli {
namespace {

struct Hint {
    std::string_view setting;
    std::string_view text;  // follows the message
};

// Flags that would help. The other settings are flags of the same name that are at fault.
constexpr Hint kHints[] = {
    {"any-device", ", and --any-device does it"},
    {"resume", "; --resume completes it"},
    {"without-guides", ": render with --denoise or --aov albedo,normal, or give --without-guides"},
};

}  // namespace

Error with_hint(Error error) {
    const std::string setting = std::exchange(error.setting, {});
    if (setting.empty()) return error;
    for (const Hint& hint : kHints)
        if (hint.setting == setting) {
            error.message += hint.text;
            return error;
        }
    error.message = fmt::format("--{}: {}", setting, error.message);
    return error;
}

}  // namespace hm::cli
