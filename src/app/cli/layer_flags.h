// The flags that say what a picture carries beside the beauty, and how OpenEXR files store it.
#pragma once

#include <CLI/CLI.hpp>

#include "app/cli/options.h"

namespace hm::cli {

void add_layer_flags(CLI::App& app, LayerOptions& options);

// Fails where the flags do not fit together: ids do not survive a lossy compression.
Result<void> check_layer_options(const LayerOptions& options);

// Bytes that the film and the file take for one pixel's AOVs, about.
double layer_bytes_per_pixel(const LayerOptions& options);

}  // namespace hm::cli
