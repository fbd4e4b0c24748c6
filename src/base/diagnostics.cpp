#include "base/diagnostics.h"
