// Validates an OpenEXR header before the library reads the file: the library allocates memory for
// the sizes in it unchecked.
#pragma once

#include "base/result.h"
#include "image/codecs.h"

namespace hm {

// Fails unless all parts are flat, attributes end inside the file, and data windows, tiles and
// channels are within the limits of read.h. Deep data and codecs of later OpenEXR versions are
// ErrorKind::unsupported.
Result<void> check_exr_header(Bytes bytes, std::string_view name);

}  // namespace hm
