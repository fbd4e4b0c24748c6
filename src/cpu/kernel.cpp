// The path-tracing stages on the CPU's BVH: the hooks that shading/path requires, and the loop over
// a tile. HM_RENDER_TILE is the name of this variant's function.
#include "cpu/kernel.h"

#include "bvh/traverse.h"
#include "shading/shading.h"

namespace hm {
namespace {

struct Stages : KernelTables {
    uvec2 image_size(uint image) const { return uvec2(images[image].width, images[image].height); }

    vec4 fetch_texel(uint image, uint x, uint y, uint encoding) const {
        return fetch_image_texel(images[image], x, y, encoding == kEncodingSrgb, srgb);
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
        auto accept = [&](const Hit& h) { return accepts(payload.key, payload.index, h); };
        if (!trace_closest(bvh, ray, hit, accept)) {
            miss(payload, direction);
            return;
        }
        const HitIds ids{hit.instance, hit.geometry, hit.primitive};
        closest_hit(payload, ids, origin, direction);
    }

    bool trace_visible(vec3 origin, vec3 direction, float t_max, uint key, uint index) {
        const Ray ray{origin, direction, t_max};
        auto accept = [&](const Hit& h) { return accepts(key, index, h); };
        return !trace_any(bvh, ray, accept);
    }

    bool accepts(uint key, uint index, const Hit& hit) {
        const HitIds ids{hit.instance, hit.geometry, hit.primitive};
        return any_hit_accepts(key, index, ids, vec2(hit.u, hit.v));
    }

#ifdef HM_AOVS
    std::size_t pixel = 0;      // index in the film
    KernelHit* hits = nullptr;  // of this pixel's samples
    uint first_index = 0;       // sample index of hits[0]

    void begin_pixel(const KernelTile& tile, uint x, uint y) {
        const std::size_t column = x - tile.x0, row = y - tile.y0;
        pixel = tile.first_pixel + row * tile.stride + column;
        first_index = tile.sample_begin;
        const std::size_t count = tile.sample_end - tile.sample_begin;
        if (tile.hits) hits = tile.hits + (row * (tile.x1 - tile.x0) + column) * count;
    }

    bool has_plane(uint plane) const {
        return planes[plane] != nullptr;
    }
    float plane_value(uint plane, uint floats, uint at) const {
        return planes[plane][pixel * floats + at];
    }
    void set_plane_value(uint plane, uint floats, uint at, float value) {
        planes[plane][pixel * floats + at] = value;
    }

    void keep_ids(uint index, const HitIds& ids) {
        if (hits) hits[index - first_index] = {ids.instance, ids.geometry};
    }

    vec3 moved_position(const HitFacts& facts) {
        const KernelGeometry& g = geometry_vertices[facts.geometry];
        const vec3* moved = next_positions[facts.geometry];
        const uvec3 i = g.triangles[facts.ids.primitive];
        const auto at = [&](uint v) { return moved ? moved[v] : g.vertices[v].position; };
        const vec3 w = facts.weights;
        const vec3 local = at(i.x) * w.x + at(i.y) * w.y + at(i.z) * w.z;
        return transform_point(next_transforms[facts.ids.instance], local);
    }
#else
    void begin_pixel(const KernelTile&, uint, uint) {}
#endif

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
            stages.begin_pixel(tile, x, y);
            for (hm::uint index = tile.sample_begin; index < tile.sample_end; ++index) {
                hm::PathSample sample{};
                stages.trace_sample(x, y, index, sample);
                tile.rays += sample.rays;
                tile.non_finite += stages.finish_path(index, sample, pixel);
            }
        }
}
