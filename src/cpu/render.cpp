#include "cpu/render.h"

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <span>
#include <vector>

#include "base/check.h"
#include "cpu/kernel.h"
#include "scene/surface_names.h"
#include "shading/tables/tables.h"

namespace hm {
namespace {

constexpr std::uint32_t kTileSize = 16;

struct InstructionSet {
    const char* name;
    hm_render_tile* render_tile;
    hm_render_tile* render_tile_aovs;
};

InstructionSet choose_instruction_set() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        return {"avx512", hm_render_tile_avx512, hm_render_tile_avx512_aovs};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {"avx2", hm_render_tile_avx2, hm_render_tile_avx2_aovs};
#endif
    return {"baseline", hm_render_tile_baseline, hm_render_tile_baseline_aovs};
}

Bvh build_scene_bvh(const FlatScene& scene) {
    std::vector<BvhMesh> meshes(scene.mesh_first_geometry.size() - 1);
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (std::uint32_t g = scene.mesh_first_geometry[m]; g < scene.mesh_first_geometry[m + 1];
             ++g) {
            const GeometryView& view = scene.geometry_views[g];
            bool opaque = scene.materials[scene.geometries[g].material].alpha_mode == kAlphaOpaque;
            meshes[m].geometries.push_back({{view.vertices, view.vertex_count},
                                            {view.triangles, view.triangle_count},
                                            opaque});
        }
    std::vector<BvhInstance> instances;
    instances.reserve(scene.instances.size());
    for (const InstanceData& i : scene.instances)
        instances.push_back({i.mesh, i.object_to_world, i.world_to_object});
    return build_bvh(meshes, instances);
}

}  // namespace

struct CpuRenderer::Impl {
    const FlatScene& scene;
    tbb::task_arena arena;
    Bvh bvh;
    InstructionSet isa = choose_instruction_set();
    std::vector<KernelGeometry> geometries;
    RenderJob job;
    KernelTables tables{};
    Film* film = nullptr;

    Impl(const FlatScene& s, unsigned threads)
        : scene(s), arena(threads == 0 ? tbb::task_arena::automatic : int(threads)) {
        arena.execute([&] { bvh = build_scene_bvh(scene); });
        for (const GeometryView& view : scene.geometry_views)
            geometries.push_back({view.vertices, view.extras, view.triangles});
    }

    // For films with AOVs.
    bool with_aovs = false;
    std::vector<const vec3*> next_positions;
    std::vector<std::uint32_t> surfaces;  // see first_surfaces

    KernelTables make_tables() const;
    void prepare_aovs();
    void render_tile(KernelTile& tile);
    void fold_hits(const KernelTile& tile, std::span<const KernelHit> hits);
    void complete(KernelTile tile, RenderCounters& counters);
};

KernelTables CpuRenderer::Impl::make_tables() const {
    const ShadingTables& constant = shading_tables();
    KernelTables t{};
#define HM_SCENE_TABLE(number, Type, name) t.name = scene.name.data();
#define HM_CONSTANT_TABLE(number, Type, name, rows) t.name = constant.name.data();
#define HM_PICTURE_TABLE(number, Type, name, rows) t.name = job.name.data();
#include "shading/tables.inl"
    t.params = job.params;
    t.camera = job.camera;
    t.environment = scene.environment;
    t.geometry_vertices = geometries.data();
    t.images = scene.images.data();
    t.srgb = srgb_table();
    t.bvh = bvh.view();
    return t;
}

CpuRenderer::CpuRenderer(const FlatScene& scene, unsigned threads)
    : impl_(std::make_unique<Impl>(scene, threads)) {}
CpuRenderer::~CpuRenderer() = default;

const BvhStats& CpuRenderer::bvh_stats() const {
    return impl_->bvh.stats;
}
std::string cpu_instruction_set() {
    return choose_instruction_set().name;
}

std::string CpuRenderer::device() const {
    return fmt::format("CPU ({})", impl_->isa.name);
}

RendererReport CpuRenderer::report() const {
    const BvhStats& s = bvh_stats();
    return {.kind = "cpu",
            .device = "CPU",
            .variant = impl_->isa.name,
            .build_seconds = s.build_seconds,
            .structure_bytes = s.bytes,
            .structure = {{"triangles", s.triangles},
                          {"degenerate_triangles", s.degenerate_triangles},
                          {"nodes", s.nodes},
                          {"packets", s.packets},
                          {"merged_instances", s.merged_instances}}};
}

void CpuRenderer::Impl::prepare_aovs() {
    const AovTables& scene_tables = scene.aovs;
    with_aovs = film->selection.needs_planes();
    if (!with_aovs) return;
    tables.aovs = aov_params(film->selection, job, !scene_tables.next_transforms.empty());
    for (FilmPlane& plane : film->planes)
        tables.planes[plane.plane] = plane.values.data();
    tables.source_groups = scene_tables.source_groups.data();
    tables.next_transforms = scene_tables.next_transforms.data();
    next_positions.clear();
    for (const std::vector<vec3>& positions : scene_tables.next_positions)
        next_positions.push_back(positions.empty() ? nullptr : positions.data());
    tables.next_positions = next_positions.data();
    surfaces = film->selection.wants_ids() ? first_surfaces(scene) : std::vector<std::uint32_t>();
    HM_CHECK(
        film->find_plane(kPlaneLightGroups) == nullptr ||
            scene_tables.source_groups.size() == 1 + scene.lights.size() + scene.materials.size(),
        "{} sources of light have a group", scene_tables.source_groups.size());
}

// Counts what the samples hit, per pixel.
void CpuRenderer::Impl::fold_hits(const KernelTile& tile, std::span<const KernelHit> hits) {
    const std::size_t width = tile.x1 - tile.x0, count = tile.sample_end - tile.sample_begin;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].instance == kNone) continue;
        const std::size_t row = i / count / width, column = i / count % width;
        add_id(film->ids[tile.first_pixel + row * tile.stride + column],
               surfaces[hits[i].instance] + hits[i].geometry, 1.0f);
    }
}

void CpuRenderer::Impl::render_tile(KernelTile& tile) {
    if (!with_aovs) {
        isa.render_tile(&tables, &tile);
        return;
    }
    if (film->ids.empty()) {
        isa.render_tile_aovs(&tables, &tile);
        return;
    }
    // Renders the samples in batches to keep the list of hits small.
    constexpr std::uint32_t kSamplesAtOnce = 64;
    const std::uint32_t end = tile.sample_end;
    const std::size_t pixels = std::size_t(tile.x1 - tile.x0) * (tile.y1 - tile.y0);
    std::uint32_t rays = 0, non_finite = 0;
    std::vector<KernelHit> hits;
    for (std::uint32_t begin = tile.sample_begin; begin < end; begin = tile.sample_end) {
        tile.sample_begin = begin;
        tile.sample_end = std::min(begin + kSamplesAtOnce, end);
        hits.assign(pixels * (tile.sample_end - begin), KernelHit{kNone, 0});
        tile.hits = hits.data();
        isa.render_tile_aovs(&tables, &tile);
        fold_hits(tile, hits);
        rays += tile.rays;
        non_finite += tile.non_finite;
    }
    tile.rays = rays;
    tile.non_finite = non_finite;
}

// Adds the missing samples of the tile's pixels. Normally all pixels have the same sample count,
// because tiles are rendered whole; a film from elsewhere may have been tiled differently and is
// completed pixel by pixel.
void CpuRenderer::Impl::complete(KernelTile tile, RenderCounters& counters) {
    const PixelRect& crop = film->crop;
    tile.stride = crop.width();
    tile.first_pixel = std::size_t(tile.y0 - crop.y0) * tile.stride + (tile.x0 - crop.x0);
    tile.pixels = &film->sums[tile.first_pixel];
    const std::uint32_t width = tile.x1 - tile.x0, height = tile.y1 - tile.y0;
    bool even = true;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            even = even && tile.pixels[y * tile.stride + x].weight == tile.pixels[0].weight;
    for (std::uint32_t i = 0; !even && i < width * height; ++i) {
        KernelTile pixel = tile;
        pixel.x0 = tile.x0 + i % width;
        pixel.y0 = tile.y0 + i / width;
        pixel.x1 = pixel.x0 + 1;
        pixel.y1 = pixel.y0 + 1;
        complete(pixel, counters);
    }
    const std::uint32_t next = film->first_sample + std::uint32_t(tile.pixels[0].weight);
    tile.sample_begin = std::max(tile.sample_begin, next);
    if (!even || tile.sample_begin >= tile.sample_end) return;
    counters.samples += std::uint64_t(width) * height * (tile.sample_end - tile.sample_begin);
    render_tile(tile);
    counters.rays += tile.rays;
    counters.non_finite += tile.non_finite;
}

Result<void> CpuRenderer::begin(const RenderJob& job, Film& film) {
    HM_CHECK(film.sums.size() == std::size_t(film.crop.width()) * film.crop.height(),
             "{} sums for {} x {}", film.sums.size(), film.crop.width(), film.crop.height());
    impl_->job = job;
    impl_->tables = impl_->make_tables();
    impl_->film = &film;
    impl_->prepare_aovs();
    return {};
}

Result<void> CpuRenderer::render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                                 const std::atomic<bool>& cancel) {
    HM_CHECK(impl_->film != nullptr, "samples {} to {} before begin", begin, end);
    const PixelRect crop = impl_->film->crop;
    const std::uint32_t columns = (crop.width() + kTileSize - 1) / kTileSize;
    const std::uint32_t rows = (crop.height() + kTileSize - 1) / kTileSize;
    auto render_tile = [&](std::uint32_t i) {
        if (cancel.load(std::memory_order_relaxed)) return;
        KernelTile tile{};
        tile.x0 = crop.x0 + i % columns * kTileSize;
        tile.y0 = crop.y0 + i / columns * kTileSize;
        tile.x1 = std::min(tile.x0 + kTileSize, crop.x1);
        tile.y1 = std::min(tile.y0 + kTileSize, crop.y1);
        tile.sample_begin = begin;
        tile.sample_end = end;
        impl_->complete(tile, counters);
    };
    impl_->arena.execute(
        [&] { tbb::parallel_for(0u, columns * rows, render_tile, tbb::simple_partitioner{}); });
    return {};
}

}  // namespace hm
