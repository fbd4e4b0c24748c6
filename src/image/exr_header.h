// A first look at an OpenEXR header. The library trusts the sizes in it and takes memory for them,
// so they are checked here before the file is handed over.
#pragma once

#include "base/result.h"
#include "image/codecs.h"

namespace hm {

// Fails unless the file has flat parts, attributes that end inside the file, and data windows,
// tiles and channels that keep to the limits of read.h. Deep data and codecs of later versions of
// OpenEXR are ErrorKind::unsupported.
Result<void> check_exr_header(Bytes bytes, std::string_view name);

}  // namespace hm
