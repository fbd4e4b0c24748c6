// The path-tracing stages over the CPU's BVH: the hooks that shading/path asks for, and the loop
// over a tile. HM_RENDER_TILE names the function of this build.
#include "cpu/kernel.h"

#include "bvh/traverse.h"
#include "shading/shading.h"

namespace hm {
namespace {

struct Stages : KernelTables {
    uvec2 image_size(uint image) const { return uvec2(images[image].width, images[image].height); }

    vec4 fetch_texel(uint image, uint x, uint y, uint is_srgb) const {
        return fetch_image_texel(images[image], x, y, is_srgb != 0u, srgb);
    }

    void load_triangle(uint geometry, uint primitive, Triangle& t) const {
        const KernelGeometry& g = geometry_vertices[geometry];
        const uvec3 i = g.triangles[primitive];
        t.a = g.vertices[i.x];
        t.b = g.vertices[i.y];
        t.c = g.vertices[i.z];
    }

    void load_triangle_extras(uint geometry, uint primitive, TriangleExtras& e) const {
        const KernelGeometry& g = geometry_vertices[geometry];
        const uvec3 i = g.triangles[primitive];
        e.a = g.extras[i.x];
        e.b = g.extras[i.y];
        e.c = g.extras[i.z];
    }

    void trace_path(PathPayload& payload, vec3 origin, vec3 direction) {
        const Ray ray{origin, direction, kInfinity};
        Hit hit;
        auto accept = [&](const Hit& h) { return accepts(payload.key, h); };
        if (!trace_closest(bvh, ray, hit, accept)) {
            miss(payload, direction);
            return;
        }
        const HitIds ids{hit.instance, hit.geometry, hit.primitive};
        closest_hit(payload, ids, origin, direction);
    }

    bool trace_visible(vec3 origin, vec3 direction, float t_max, uint key) {
        const Ray ray{origin, direction, t_max};
        auto accept = [&](const Hit& h) { return accepts(key, h); };
        return !trace_any(bvh, ray, accept);
    }

    bool accepts(uint key, const Hit& hit) {
        const HitIds ids{hit.instance, hit.geometry, hit.primitive};
        return any_hit_accepts(key, ids, vec2(hit.u, hit.v));
    }

#include "shading/path/path.h"
};

}  // namespace
}  // namespace hm

extern "C" void HM_RENDER_TILE(const void* tables, void* tile_data) {
    hm::Stages stages{*static_cast<const hm::KernelTables*>(tables)};
    hm::KernelTile& tile = *static_cast<hm::KernelTile*>(tile_data);
    tile.rays = 0;
    tile.non_finite = 0;
    for (hm::uint y = tile.y0; y < tile.y1; ++y)
        for (hm::uint x = tile.x0; x < tile.x1; ++x) {
            hm::PixelSum& pixel = tile.pixels[(y - tile.y0) * tile.stride + (x - tile.x0)];
            for (hm::uint index = tile.sample_begin; index < tile.sample_end; ++index) {
                hm::PathSample sample;
                stages.trace_sample(x, y, index, sample);
                tile.rays += sample.rays;
                if (!stages.add_sample(pixel, sample)) ++tile.non_finite;
            }
        }
}
