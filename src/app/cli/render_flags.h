// The flags of `himalaya render`; their help texts are the manual.
#pragma once

#include "app/cli/cli11.h"
#include "app/cli/options.h"

namespace hm::cli {

// `options` must outlive the parsing; invalid flags throw CLI::ParseError.
void add_render_flags(CLI::App& app, RenderOptions& options);

void add_device_flag(CLI::App& app, DeviceChoice& device);

// Whether the flags fit together. Fails with ErrorKind::invalid_argument or, for outputs,
// unwritable.
Result<void> check_render_options(const RenderOptions& options);

}  // namespace hm::cli
