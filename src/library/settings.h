// The public settings -> the session's.
#pragma once

#include <himalaya/settings.h>

#include "session/settings.h"

namespace himalaya {

// Throws Error of kind invalid_argument.
hm::RenderSettings to_session(const RenderSettings& settings);

}  // namespace himalaya
