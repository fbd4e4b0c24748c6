// The flags for AOVs and other layers, and for how OpenEXR files store them.
#pragma once

#include "app/cli/cli11.h"
#include "session/settings.h"

namespace hm::cli {

void add_layer_flags(CLI::App& app, LayerSettings& options);

}  // namespace hm::cli
