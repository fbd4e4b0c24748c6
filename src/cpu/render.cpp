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
#include "shading/tables/tables.h"

namespace hm {
namespace {

constexpr std::uint32_t kTileSize = 16;

struct InstructionSet {
    const char* name;
    hm_render_tile* render_tile;
};

InstructionSet choose_instruction_set() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        return {"avx512", hm_render_tile_avx512};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {"avx2", hm_render_tile_avx2};
#endif
    return {"baseline", hm_render_tile_baseline};
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

    KernelTables make_tables() const;
};

KernelTables CpuRenderer::Impl::make_tables() const {
    const ShadingTables& constant = shading_tables();
    KernelTables t{};
    t.materials = scene.materials.data();
    t.texture_uses = scene.texture_uses.data();
    t.images = scene.images.data();
    t.geometries = scene.geometries.data();
    t.geometry_vertices = geometries.data();
    t.instances = scene.instances.data();
    t.lights = scene.lights.data();
    t.light_alias = scene.light_alias.data();
    t.emitters = scene.emitters.data();
    t.emitter_alias = scene.emitter_alias.data();
    t.environment_texels = scene.environment.texels.data();
    t.environment_alias = scene.environment.alias.data();
    t.sobol_directions = constant.sobol_directions.data();
    t.sobol_nibbles = constant.sobol_nibbles.data();
    t.blue_noise = constant.blue_noise.data();
    t.albedo_table = constant.albedo_table.data();
    t.albedo_average = constant.albedo_average.data();
    t.filter_table = job.filter_table.data();
    t.srgb = srgb_table();
    t.bvh = bvh.view();
    t.environment = scene.environment.data;
    t.camera = job.camera;
    t.params = job.params;
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

Result<void> CpuRenderer::begin(const RenderJob& job, Film& film) {
    HM_CHECK(film.sums.size() == std::size_t(film.crop.width()) * film.crop.height(),
             "{} sums for {} x {}", film.sums.size(), film.crop.width(), film.crop.height());
    impl_->job = job;
    impl_->tables = impl_->make_tables();
    impl_->film = &film;
    return {};
}

Result<void> CpuRenderer::render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                                 const std::atomic<bool>& cancel) {
    HM_CHECK(impl_->film != nullptr, "samples {} to {} before begin", begin, end);
    const PixelRect crop = impl_->film->crop;
    const std::span<PixelSum> sums = impl_->film->sums;
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
        std::size_t first = std::size_t(tile.y0 - crop.y0) * crop.width() + (tile.x0 - crop.x0);
        tile.pixels = sums.data() + first;
        tile.stride = crop.width();
        impl_->isa.render_tile(&impl_->tables, &tile);
        counters.samples += std::uint64_t(tile.x1 - tile.x0) * (tile.y1 - tile.y0) * (end - begin);
        counters.rays += tile.rays;
        counters.non_finite += tile.non_finite;
    };
    impl_->arena.execute(
        [&] { tbb::parallel_for(0u, columns * rows, render_tile, tbb::simple_partitioner{}); });
    return {};
}

}  // namespace hm
