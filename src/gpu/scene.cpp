#include "gpu/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "gpu/tables.h"
#include "shading/tables/tables.h"

namespace hm {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class T>
std::span<const std::byte> bytes_of(const T& values) {
    return std::as_bytes(std::span(values));
}

std::uint64_t table_bytes(const FlatScene& scene) {
    std::uint64_t sum = 0;
#define HM_SCENE_TABLE(number, Type, name) sum += bytes_of(scene.name).size();
#include "shading/tables.inl"
    return sum;
}

// Structures take 50 to 100 bytes a triangle on the drivers we know, and during compaction a batch
// exists twice.
constexpr std::uint64_t kStructureBytesPerTriangle = 100;

std::uint64_t triangle_count(const FlatScene& scene) {
    std::uint64_t sum = 0;
    for (const GeometryData& g : scene.geometries)
        sum += g.triangle_count;
    return sum;
}

Result<void> check_memory(const rhi::Device& device, const FlatScene& scene) {
    const std::uint64_t need = geometry_bytes(scene) + texture_bytes(scene) + table_bytes(scene) +
                               triangle_count(scene) * kStructureBytesPerTriangle;
    const rhi::MemoryUse memory = device.memory_use();
    const std::uint64_t room =
        memory.budget_bytes - std::min(memory.budget_bytes, memory.used_bytes);
    if (need <= room) return {};
    const auto gib = [](std::uint64_t bytes) { return double(bytes) / double(1u << 30); };
    return fail(ErrorKind::device_failed, "", "",
                fmt::format("the scene needs about {:.1f} GiB of device memory, {} has {:.1f} GiB "
                            "free",
                            gib(need), device.physical().name, gib(room)));
}

}  // namespace

GpuScene::GpuScene(rhi::Device& device, rhi::Uploader uploader)
    : device_(device), uploader_(std::move(uploader)) {}

Result<void> GpuScene::add_table(rhi::DescriptorWrites& writes, std::uint32_t binding,
                                 const char* name, std::span<const std::byte> bytes) {
    if (bytes.size() > device_.limits().max_storage_buffer_bytes)
        return fail(
            ErrorKind::device_failed, "", "",
            fmt::format("the scene's table {} is {} bytes, {} takes {}", name, bytes.size(),
                        device_.physical().name, device_.limits().max_storage_buffer_bytes));
    // A buffer is never empty; nothing reads the padding.
    const std::uint64_t size = std::max<std::uint64_t>(bytes.size(), 128);
    const rhi::BufferUse use =
        binding == kFrameBinding ? rhi::BufferUse::uniform : rhi::BufferUse::storage;
    rhi::Buffer& table = tables_[binding];
    HM_TRY_ASSIGN(table, rhi::Buffer::create(device_, {name, size, use}));
    if (!bytes.empty()) HM_TRY(uploader_.buffer(table, bytes));
    writes.buffer(binding, table);
    report_.table_bytes += size;
    return {};
}

// The frame values and the tables of a picture are zero until set_frame.
Result<void> GpuScene::upload_tables(const FlatScene& scene, rhi::DescriptorWrites& writes) {
    const ShadingTables& constants = shading_tables();
    const RenderJob empty;
    const FrameData frame{};
    HM_TRY(add_table(writes, kFrameBinding, "frame", bytes_of(std::span(&frame, 1))));
    HM_TRY(add_table(writes, kGeometryAddressesBinding, "geometry_addresses",
                     bytes_of(geometry_.addresses)));
#define HM_UPLOAD(number, owner, name) \
    HM_TRY(add_table(writes, kFirstTableBinding + number, #name, bytes_of(owner.name)));
#define HM_SCENE_TABLE(number, Type, name) HM_UPLOAD(number, scene, name)
#define HM_CONSTANT_TABLE(number, Type, name, rows) HM_UPLOAD(number, constants, name)
#define HM_PICTURE_TABLE(number, Type, name, rows) HM_UPLOAD(number, empty, name)
#include "shading/tables.inl"
#undef HM_UPLOAD
    return {};
}

Result<std::unique_ptr<GpuScene>> GpuScene::create(rhi::Device& device, const SceneLayouts& layouts,
                                                   const FlatScene& scene) {
    HM_TRY(check_memory(device, scene));
    const auto start = std::chrono::steady_clock::now();
    HM_TRY_ASSIGN(rhi::Uploader uploader, rhi::Uploader::create(device));
    std::unique_ptr<GpuScene> gpu(new GpuScene(device, std::move(uploader)));
    gpu->environment_ = scene.environment;
    gpu->has_extended_materials_ = !scene.extended_materials.empty();
    gpu->tables_.resize(layouts.scene.bindings().size());
    HM_TRY_ASSIGN(gpu->geometry_, GpuGeometry::upload(device, gpu->uploader_, scene));
    HM_TRY_ASSIGN(gpu->textures_,
                  GpuTextures::upload(device, gpu->uploader_, layouts.textures, scene));
    rhi::DescriptorWrites writes(layouts.scene);
    HM_TRY(gpu->upload_tables(scene, writes));
    HM_TRY(gpu->uploader_.finish());
    gpu->report_.upload_seconds = seconds_since(start);

    const auto build_start = std::chrono::steady_clock::now();
    HM_TRY_ASSIGN(gpu->structures_,
                  SceneStructures::build(device, gpu->uploader_, scene, gpu->geometry_));
    gpu->report_.build_seconds = seconds_since(build_start);
    writes.acceleration_structure(kStructureBinding, gpu->structures_.tlas);
    HM_TRY_ASSIGN(gpu->set_, rhi::DescriptorSet::create(device, "scene", layouts.scene));
    gpu->set_.update(writes);

    GpuSceneReport& report = gpu->report_;
    report.geometry_bytes = gpu->geometry_.bytes();
    report.texture_bytes = hm::texture_bytes(scene);
    report.structure_bytes = gpu->structures_.bytes();
    report.triangles = triangle_count(scene) - gpu->geometry_.degenerate_triangles;
    report.degenerate_triangles = gpu->geometry_.degenerate_triangles;
    report.instances = gpu->structures_.instances;
    report.duplicate_instances = gpu->structures_.duplicates;
    report.build = gpu->structures_.report;
    return gpu;
}

Result<void> GpuScene::set_frame(const RenderJob& job) {
    const FrameData frame{job.params, job.camera, environment_};
    HM_TRY(uploader_.buffer(tables_[kFrameBinding], bytes_of(std::span(&frame, 1))));
#define HM_PICTURE_TABLE(number, Type, name, rows) \
    HM_TRY(uploader_.buffer(tables_[kFirstTableBinding + number], bytes_of(job.name)));
#include "shading/tables.inl"
    return uploader_.finish();
}

}  // namespace hm
