// Pictures of an animation: the moment of one, and the numbers, files and seeds of a sequence.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/cli/options.h"
#include "app/cli/values.h"
#include "base/diagnostics.h"
#include "scene/pose.h"

namespace hm::cli {

Parsed<FrameRange> parse_frames(std::string_view text);  // "A:B", both included

// Whether the file's name has exactly one run of '#'.
bool has_frame_pattern(const std::filesystem::path& path);

// The run replaced by the number, padded with zeros to the run's length.
std::filesystem::path frame_path(const std::filesystem::path& pattern, std::uint32_t number);

// The options that draw one frame of a sequence alone: --at, --seed and the outputs.
RenderOptions frame_options(const RenderOptions& options, std::uint32_t number);

// Where and when the scene's animation stands; nothing for the rest pose. Fails with
// ErrorKind::invalid_argument where the scene does not have the animation.
Result<std::optional<PoseTime>> choose_pose(const RenderOptions& options, const Scene& scene,
                                            Diagnostics& diagnostics);

}  // namespace hm::cli
