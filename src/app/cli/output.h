// Standard output, where reports go.
#pragma once

#include <string_view>

#include "base/result.h"

namespace hm::cli {

// Fails with ExitCode::unwritable.
Result<void> print(std::string_view text);

}  // namespace hm::cli
