// Errors in the words of the command line: which flag is at fault, or which one would help.
#pragma once

#include "base/result.h"

namespace hm::cli {

// The error with its setting (Error::setting) named as a flag in the message.
Error with_hint(Error error);

}  // namespace hm::cli
