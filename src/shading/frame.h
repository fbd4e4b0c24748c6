// Orthonormal frames around a unit normal (Duff et al., "Building an Orthonormal Basis, Revisited",
// JCGT 2017).
#ifndef HM_SHADING_FRAME_H
#define HM_SHADING_FRAME_H

#include "shading/lang.h"

HM_NAMESPACE_BEGIN

struct Frame {
    vec3 s;
    vec3 t;
    vec3 n;
};

HM_FN void make_frame(vec3 n, HM_OUT(Frame) frame) {
    float side = n.z < 0.0f ? -1.0f : 1.0f;
    float a = divide(-1.0f, side + n.z);
    float b = n.x * n.y * a;
    frame.s = vec3(1.0f + side * n.x * n.x * a, side * b, -side * n.x);
    frame.t = vec3(b, side + n.y * n.y * a, -n.y);
    frame.n = n;
}

HM_FN vec3 to_local(HM_IN(Frame) frame, vec3 v) {
    return vec3(dot(v, frame.s), dot(v, frame.t), dot(v, frame.n));
}

HM_FN vec3 to_world(HM_IN(Frame) frame, vec3 v) {
    return frame.s * v.x + frame.t * v.y + frame.n * v.z;
}

HM_NAMESPACE_END

#endif
