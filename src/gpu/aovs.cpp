#include "gpu/aovs.h"

#include <algorithm>
#include <cstddef>

#include "base/check.h"

namespace hm {
namespace {

// The buffer that aovs.glsl declares at binding 8.
struct AovTable {
    AovParams params;
    AovAddresses addresses;
};
static_assert(offsetof(AovTable, addresses) == sizeof(AovParams));

uvec2 address_words(const rhi::Buffer& buffer) {
    if (!buffer) return uvec2(0);
    return uvec2(std::uint32_t(buffer.address()), std::uint32_t(buffer.address() >> 32));
}

// No buffer for no values.
template <class T>
Result<rhi::Buffer> upload_values(rhi::Device& device, rhi::Uploader& uploader, const char* name,
                                  std::span<const T> values) {
    if (values.empty()) return rhi::Buffer{};
    return rhi::upload_buffer(uploader, device, {name, values.size_bytes()}, std::as_bytes(values));
}

}  // namespace

Result<GpuAovs> GpuAovs::create(rhi::Device& device, const FlatScene& scene, const RenderJob& job,
                                const Film& film) {
    const AovTables& tables = scene.aovs;
    HM_CHECK(film.find_plane(kPlaneLightGroups) == nullptr ||
                 tables.source_groups.size() == 1 + scene.lights.size() + scene.materials.size(),
             "{} sources of light have a group", tables.source_groups.size());
    GpuAovs out;
    HM_TRY_ASSIGN(rhi::Uploader uploader, rhi::Uploader::create(device));
    AovTable table{aov_params(film.selection, job, !tables.next_transforms.empty()), {}};
    for (const FilmPlane& plane : film.planes) {
        HM_TRY_ASSIGN(rhi::Buffer values,
                      upload_values<float>(device, uploader, "AOV plane", plane.values));
        table.addresses.planes[plane.plane] = address_words(values);
        out.planes_.push_back(std::move(values));
    }
    // Shaders may look up a group even if none was requested: never an empty buffer.
    std::vector<std::uint32_t> groups = tables.source_groups;
    groups.resize(std::max<std::size_t>(groups.size(), 4));
    HM_TRY_ASSIGN(out.source_groups_,
                  upload_values<std::uint32_t>(device, uploader, "light groups", groups));
    HM_TRY_ASSIGN(out.next_transforms_, upload_values<mat4x3>(device, uploader, "next transforms",
                                                              tables.next_transforms));
    std::vector<uvec2> moved(scene.geometries.size(), uvec2(0));
    for (std::size_t g = 0; g < tables.next_positions.size(); ++g) {
        HM_TRY_ASSIGN(rhi::Buffer positions, upload_values<vec3>(device, uploader, "next positions",
                                                                 tables.next_positions[g]));
        moved[g] = address_words(positions);
        if (positions) out.moved_.push_back(std::move(positions));
    }
    HM_TRY_ASSIGN(out.next_positions_,
                  upload_values<uvec2>(device, uploader, "next positions", moved));
    table.addresses.next_transforms = address_words(out.next_transforms_);
    table.addresses.next_positions = address_words(out.next_positions_);
    HM_TRY_ASSIGN(out.table_,
                  upload_values<AovTable>(device, uploader, "AOV table", std::span(&table, 1)));
    HM_TRY(uploader.finish());
    return out;
}

Result<std::vector<std::vector<float>>> GpuAovs::download(rhi::Device& device) const {
    std::vector<std::vector<float>> values;
    for (const rhi::Buffer& plane : planes_) {
        values.emplace_back(plane.size() / sizeof(float));
        HM_TRY(rhi::read_back(device, plane, std::as_writable_bytes(std::span(values.back()))));
    }
    return values;
}

void count_hits(std::span<const SampleHit> hits, const Batch& batch, std::uint32_t width,
                std::span<const std::uint32_t> surfaces, std::vector<IdList>& ids) {
    const std::size_t samples = batch.samples_per_pixel();
    const std::size_t first = std::size_t(batch.first_row) * width;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (hits[i].instance == kNone) continue;
        add_id(ids[first + i / samples], surfaces[hits[i].instance] + hits[i].geometry, 1.0f);
    }
}

}  // namespace hm
