// The frames of a sequence: their numbers, files and flags.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/cli/options.h"
#include "app/cli/values.h"

namespace hm::cli {

Parsed<FrameRange> parse_frames(std::string_view text);  // "A:B", both included

// Whether the file's name has exactly one run of '#'.
bool has_frame_pattern(const std::filesystem::path& path);

// The run replaced by the number, padded with zeros to the run's length.
std::filesystem::path frame_path(const std::filesystem::path& pattern, std::uint32_t number);

// The options that draw one frame of a sequence alone: time, seed and outputs.
RenderOptions frame_options(const RenderOptions& options, std::uint32_t number);

}  // namespace hm::cli
