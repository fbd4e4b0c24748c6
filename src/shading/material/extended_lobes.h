// The lobes of materials with extensions, in the order that each needs the ones before. After
// bsdf.h.
//
// The CPU's stages always have them (HM_EXTENDED). A GPU compiles its closest hit with and without,
// for scenes that have such materials and that have none: the registers of the larger one cost a
// core scene 3 to 5 %, even if a specialization constant says that nothing is extended.
#ifdef HM_EXTENDED
// clang-format off
#include "shading/material/extended_textures.h"
#include "shading/material/energy.h"
#include "shading/material/coat.h"
#include "shading/material/extended.h"
#include "shading/material/extended_specular.h"
#include "shading/material/extended_bsdf.h"
#include "shading/path/media.h"
// clang-format on
#else
#include "shading/material/extended_off.h"
#endif
