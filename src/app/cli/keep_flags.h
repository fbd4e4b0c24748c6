// The flags for checkpoints, resuming and rendering in parts.
#pragma once

#include "app/cli/cli11.h"
#include "app/cli/options.h"

namespace hm::cli {

void add_keep_flags(CLI::App& app, RenderOptions& options);

// Fails if the flags contradict each other, or a checkpoint would be overwritten or can't be
// written.
Result<void> check_keep_options(const RenderOptions& options);

}  // namespace hm::cli
