// Host for the light sampling code of the stages on a flat scene, without a ray tracer.
#pragma once

#include "scene/flatten.h"
#include "scene/render_params.h"
#include "shading/shading.h"
#include "shading/tables/tables.h"

namespace hm::test {

struct LightHost {
    const FlatScene& flat;
    RenderParams params;
    EnvironmentData environment = flat.environment;
#define HM_SCENE_TABLE(number, Type, name) const Type* name = flat.name.data();
#define HM_CONSTANT_TABLE(number, Type, name, rows) const Type* name = shading_tables().name.data();
#include "shading/tables.inl"

    explicit LightHost(const FlatScene& scene, uint strategy = kStrategyMis)
        : flat(scene), params(make_params(scene, 0, 0, {.strategy = strategy})) {}

    uvec2 image_size(uint image) const {
        return {flat.images[image].width, flat.images[image].height};
    }
    vec4 fetch_texel(uint image, uint x, uint y, uint encoding) const {
        return fetch_image_texel(flat.images[image], x, y, encoding == kEncodingSrgb, srgb_table());
    }
    void load_triangle(uint geometry, uint primitive, Triangle& t) const {
        const GeometryView& view = flat.geometry_views[geometry];
        uvec3 i = view.triangles[primitive];
        t = {view.vertices[i.x], view.vertices[i.y], view.vertices[i.z]};
    }
    void load_triangle_extras(uint geometry, uint primitive, TriangleExtras& e) const {
        const GeometryView& view = flat.geometry_views[geometry];
        uvec3 i = view.triangles[primitive];
        e = {view.extras[i.x], view.extras[i.y], view.extras[i.z]};
    }

// clang-format off
#include "shading/texture/lookup.h"
#include "shading/material/textures.h"
#include "shading/path/surface.h"
#include "shading/material/material.h"
#include "shading/material/bsdf.h"
#include "shading/material/extended_lobes.h"
#include "shading/light/light.h"
    // clang-format on
};

}  // namespace hm::test
