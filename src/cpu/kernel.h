// The inner loop of the CPU renderer, compiled once per instruction set. The interface is plain
// data: the kernels' translation units rename hm and glm (see CMakeLists.txt), so that the linker
// never uses an inline function built for a newer CPU in the rest of the program.
#pragma once

#include "bvh/view.h"
#include "scene/image_view.h"
#include "shading/path/aov_planes.h"
#include "shading/path/types.h"

namespace hm {

struct KernelGeometry {
    const Vertex* vertices;
    const VertexExtra* extras;
    const uvec3* triangles;
};

// All data that the stages and their hooks read, under the names that the stages use.
struct KernelTables {
#define HM_FRAME_VALUE(Type, name) Type name;
#define HM_TABLE(number, Type, name) const Type* name;
#include "shading/tables.inl"
    const KernelGeometry* geometry_vertices;
    const ImageView* images;
    const float* srgb;
    BvhView bvh;

    // For the variants with AOVs.
    AovParams aovs;
    float* planes[kPlaneCount];         // of the film, from its first pixel; null: not requested
    const uint* source_groups;          // light group of each light source
    const mat4x3* next_transforms;      // per instance, at the next frame
    const vec3* const* next_positions;  // per geometry; null: its vertices do not move
};

struct KernelHit {
    uint instance;
    uint geometry;  // within the instance's mesh
};

// Pixels [x0, x1) x [y0, y1), samples [sample_begin, sample_end), added to pixels[(y - y0) * stride
// + x - x0].
struct KernelTile {
    uint x0, y0, x1, y1;
    uint sample_begin, sample_end;
    PixelSum* pixels;
    uint stride;
    // For the variants with AOVs:
    std::size_t first_pixel;  // index of `pixels[0]` in the film
    KernelHit* hits;  // what each sample hits: for each pixel of the tile, row by row, one per
                      // sample; unchanged for samples that hit nothing. Null: not requested
    uint rays;        // output
    uint non_finite;  // output
};

}  // namespace hm

extern "C" {
// Arguments are hm::KernelTables and hm::KernelTile; hm is renamed in the kernels' variants.
using hm_render_tile = void(const void* tables, void* tile);
hm_render_tile hm_render_tile_baseline, hm_render_tile_baseline_aovs;
#if defined(__x86_64__)
hm_render_tile hm_render_tile_avx2, hm_render_tile_avx2_aovs;
hm_render_tile hm_render_tile_avx512, hm_render_tile_avx512_aovs;
#endif
}
