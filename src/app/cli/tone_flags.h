// The flags for exposure and tone mapping of PNG files.
#pragma once

#include <cstdint>
#include <optional>

#include "app/cli/cli11.h"

namespace hm::cli {

// An exposure in EV, none for auto, and a kTone* curve. Both must outlive the parsing; invalid
// flags throw CLI::ParseError.
void add_tone_flags(CLI::App& app, std::optional<float>& exposure, std::uint32_t& curve);

}  // namespace hm::cli
