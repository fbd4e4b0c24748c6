// Standard output, with its failures noticed.
#pragma once

#include <string_view>

#include "base/result.h"

namespace hm::cli {

// Written out at once. Fails with ExitCode::unwritable.
Result<void> print(std::string_view text);

}  // namespace hm::cli
