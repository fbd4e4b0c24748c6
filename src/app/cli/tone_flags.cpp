#include "app/cli/tone_flags.h"

#include <CLI/CLI.hpp>

#include "app/cli/flag.h"
#include "app/cli/values.h"
#include "session/choices.h"

namespace hm::cli {

void add_tone_flags(CLI::App& app, std::optional<float>& exposure, std::uint32_t& curve) {
    add(
        app, "--exposure", "EV|auto", exposure,
        [](const std::string& text) -> Parsed<std::optional<float>> {
            if (text == "auto") return std::optional<float>();
            return parse_number(text, -32, 32).map([](float ev) { return std::optional(ev); });
        },
        "PNG only: multiply by 2^EV (0). auto: the log-average of what is lit becomes 0.18");
    add(
        app, "--tonemap", "NAME", curve,
        [](const std::string& text) { return parse_choice(text, kToneCurves); },
        "PNG only: neutral (Khronos PBR Neutral, the default), aces, agx or linear");
}

}  // namespace hm::cli
