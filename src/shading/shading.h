// Everything in shading/ that needs no tables: pure functions and the types the stages share.
#ifndef HM_SHADING_SHADING_H
#define HM_SHADING_SHADING_H

#include "shading/camera.h"
#include "shading/color.h"
#include "shading/frame.h"
#include "shading/geometry.h"
#include "shading/light/alias.h"
#include "shading/light/punctual.h"
#include "shading/material/fresnel.h"
#include "shading/material/ggx.h"
#include "shading/material/ggx_anisotropic.h"
#include "shading/material/point.h"
#include "shading/material/sheen.h"
#include "shading/material/thin_film.h"
#include "shading/material/transmission.h"
#include "shading/math.h"
#include "shading/path/types.h"
#include "shading/rng.h"
#include "shading/structs.h"
#include "shading/warp.h"

#endif
