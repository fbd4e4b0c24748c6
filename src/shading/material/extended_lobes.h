// The lobes of materials with extensions, in the order that each needs the ones before. After
// bsdf.h.
// clang-format off
#include "shading/material/energy.h"
#include "shading/material/coat.h"
#include "shading/material/extended.h"
#include "shading/material/extended_specular.h"
#include "shading/material/extended_bsdf.h"
// clang-format on
