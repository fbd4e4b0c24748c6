// The flags for renderings that are kept, gone on with, and drawn in parts.
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/options.h"

namespace hm::cli {

void add_keep_flags(CLI::App& app, RenderOptions& options);

// Fails where the flags do not fit together, or a checkpoint would be lost or can't be written.
Result<void> check_keep_options(const RenderOptions& options);

}  // namespace hm::cli
