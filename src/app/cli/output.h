// Standard output, where reports go, and standard error, where messages go.
#pragma once

#include <string_view>

#include "base/result.h"

namespace hm::cli {

// Fails with ErrorKind::unwritable.
Result<void> print(std::string_view text);

// Writes to standard error; failures are ignored.
void tell(std::string_view text);

}  // namespace hm::cli
