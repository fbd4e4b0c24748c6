// The flags that say what a picture carries beside the beauty, and how OpenEXR files store it.
#pragma once

#include <CLI/CLI.hpp>

#include "session/settings.h"

namespace hm::cli {

void add_layer_flags(CLI::App& app, LayerSettings& options);

}  // namespace hm::cli
