// A first look at an OpenEXR header. The library trusts the sizes in it and takes memory for them,
// so they are checked here before the file is handed over.
#pragma once

#include "base/result.h"
#include "image/codecs.h"

namespace hm {

// Fails unless the file has one flat part, attributes that end inside the file, and a data window,
// tiles and channels that keep to the limits of read.h.
Result<void> check_exr_header(Bytes bytes, std::string_view name);

}  // namespace hm
