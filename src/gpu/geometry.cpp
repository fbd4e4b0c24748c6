#include "gpu/geometry.h"

#include <algorithm>
#include <limits>
#include <span>

#include "shading/degenerate.h"

namespace hm {
namespace {

// Small geometries share a buffer; a larger one has its own.
constexpr std::uint64_t kChunkBytes = 64u << 20;
constexpr std::uint64_t kAlignment = 16;  // of VertexArray in bindings.glsl

std::uint64_t aligned(std::uint64_t bytes) {
    return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

// A geometry's arrays one after the other, each with one vertex more than in the scene.
struct Placement {
    std::size_t buffer = 0;
    std::uint64_t vertices = 0, extras = 0, triangles = 0, end = 0;  // offsets
};

Placement place(const GeometryView& view, std::size_t buffer, std::uint64_t begin) {
    const std::uint64_t count = std::uint64_t(view.vertex_count) + 1;
    Placement p{buffer, begin, 0, 0, 0};
    p.extras = aligned(p.vertices + count * sizeof(Vertex));
    const std::uint64_t extras = view.extras != nullptr ? count * sizeof(VertexExtra) : 0;
    p.triangles = aligned(p.extras + extras);
    p.end = aligned(p.triangles + std::uint64_t(view.triangle_count) * sizeof(uvec3));
    return p;
}

std::vector<Placement> plan_buffers(const FlatScene& scene, std::vector<std::uint64_t>& sizes) {
    std::vector<Placement> placements;
    for (const GeometryView& view : scene.geometry_views) {
        const std::uint64_t bytes = place(view, 0, 0).end;
        if (sizes.empty() || sizes.back() + bytes > kChunkBytes) sizes.push_back(0);
        placements.push_back(place(view, sizes.size() - 1, sizes.back()));
        sizes.back() = placements.back().end;
    }
    return placements;
}

// Builders skip a triangle with a vertex whose x is NaN but count it, so the others keep their
// indices.
Vertex no_vertex() {
    Vertex v{};
    v.position = vec3(std::numeric_limits<float>::quiet_NaN());
    return v;
}

std::vector<uvec3> without_degenerates(const GeometryView& view, std::uint64_t& degenerate) {
    std::vector<uvec3> triangles(view.triangles, view.triangles + view.triangle_count);
    for (uvec3& t : triangles) {
        if (!is_degenerate(view.vertices[t.x].position, view.vertices[t.y].position,
                           view.vertices[t.z].position))
            continue;
        t = uvec3(view.vertex_count);
        ++degenerate;
    }
    return triangles;
}

template <class T>
Result<void> write(rhi::Uploader& uploader, const rhi::Buffer& to, std::uint64_t offset,
                   const T* values, std::size_t count) {
    if (count == 0) return {};
    return uploader.buffer(to, std::as_bytes(std::span(values, count)), offset);
}

Result<void> write_geometry(rhi::Uploader& uploader, const GeometryView& view, const Placement& p,
                            GpuGeometry& out) {
    const rhi::Buffer& buffer = out.buffers[p.buffer];
    const Vertex none = no_vertex();
    const std::uint64_t last = view.vertex_count;
    HM_TRY(write(uploader, buffer, p.vertices, view.vertices, view.vertex_count));
    HM_TRY(write(uploader, buffer, p.vertices + last * sizeof(Vertex), &none, 1));
    if (view.extras != nullptr) {
        const VertexExtra extra{};
        HM_TRY(write(uploader, buffer, p.extras, view.extras, view.vertex_count));
        HM_TRY(write(uploader, buffer, p.extras + last * sizeof(VertexExtra), &extra, 1));
    }
    const std::vector<uvec3> triangles = without_degenerates(view, out.degenerate_triangles);
    return write(uploader, buffer, p.triangles, triangles.data(), triangles.size());
}

uvec2 address_words(std::uint64_t address) {
    return uvec2(std::uint32_t(address), std::uint32_t(address >> 32));
}

}  // namespace

std::uint64_t GpuGeometry::bytes() const {
    std::uint64_t sum = 0;
    for (const rhi::Buffer& b : buffers)
        sum += b.size();
    return sum;
}

Result<GpuGeometry> GpuGeometry::upload(rhi::Device& device, rhi::Uploader& uploader,
                                        const FlatScene& scene) {
    GpuGeometry out;
    std::vector<std::uint64_t> sizes;
    const std::vector<Placement> placements = plan_buffers(scene, sizes);
    for (const std::uint64_t size : sizes) {
        const rhi::BufferUse use = rhi::BufferUse::storage | rhi::BufferUse::build_input;
        HM_TRY_ASSIGN(rhi::Buffer buffer,
                      rhi::Buffer::create(
                          device, {"geometry", size, use, rhi::MemoryKind::device, kAlignment}));
        out.buffers.push_back(std::move(buffer));
    }
    for (std::size_t g = 0; g < placements.size(); ++g) {
        const GeometryView& view = scene.geometry_views[g];
        const Placement& p = placements[g];
        HM_TRY(write_geometry(uploader, view, p, out));
        const std::uint64_t base = out.buffers[p.buffer].address();
        out.addresses.push_back({address_words(base + p.vertices),
                                 view.extras != nullptr ? address_words(base + p.extras) : uvec2(0),
                                 address_words(base + p.triangles)});
        out.vertex_counts.push_back(view.vertex_count + 1);
    }
    return out;
}

std::uint64_t geometry_bytes(const FlatScene& scene) {
    std::vector<std::uint64_t> sizes;
    plan_buffers(scene, sizes);
    std::uint64_t sum = 0;
    for (const std::uint64_t size : sizes)
        sum += size;
    return sum;
}

}  // namespace hm
