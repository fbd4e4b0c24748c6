#include "gpu/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>

#include "base/check.h"
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
    return bytes_of(scene.materials).size() + bytes_of(scene.instances).size() +
           bytes_of(scene.emitters).size() + bytes_of(scene.emitter_alias).size() +
           bytes_of(scene.environment.texels).size() + bytes_of(scene.environment.alias).size();
}

// Structures take 50 to 100 bytes a triangle on the drivers we know, and while they are compacted
// there are two of a batch.
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

Result<void> GpuScene::add_table(rhi::DescriptorWrites& writes, SceneBinding binding,
                                 const char* name, std::span<const std::byte> bytes) {
    if (bytes.size() > device_.limits().max_storage_buffer_bytes)
        return fail(
            ErrorKind::device_failed, "", "",
            fmt::format("the scene's table of {} is {} bytes, {} takes {}", name, bytes.size(),
                        device_.physical().name, device_.limits().max_storage_buffer_bytes));
    // No buffer is empty; nothing reads the row that stands for none.
    const std::uint64_t size = std::max<std::uint64_t>(bytes.size(), 128);
    rhi::Buffer& table = tables_[std::size_t(binding)];
    const bool frame = binding == SceneBinding::frame;
    HM_TRY_ASSIGN(table, rhi::Buffer::create(
                             device_, {name, size,
                                       frame ? rhi::BufferUse::uniform : rhi::BufferUse::storage}));
    if (!bytes.empty()) HM_TRY(uploader_.buffer(table, bytes));
    writes.buffer(std::uint32_t(binding), table);
    report_.table_bytes += size;
    return {};
}

Result<void> GpuScene::upload_tables(const FlatScene& scene, rhi::DescriptorWrites& writes) {
    using B = SceneBinding;
    HM_TRY(add_table(writes, B::lights, "lights", bytes_of(scene.lights)));
    HM_TRY(add_table(writes, B::materials, "materials", bytes_of(scene.materials)));
    HM_TRY(add_table(writes, B::instances, "instances", bytes_of(scene.instances)));
    HM_TRY(add_table(writes, B::geometry_addresses, "geometry addresses",
                     bytes_of(geometry_.addresses)));
    HM_TRY(add_table(writes, B::geometries, "geometries", bytes_of(scene.geometries)));
    HM_TRY(add_table(writes, B::texture_uses, "texture uses", bytes_of(scene.texture_uses)));
    HM_TRY(add_table(writes, B::light_alias, "light choice", bytes_of(scene.light_alias)));
    HM_TRY(add_table(writes, B::emitters, "emitters", bytes_of(scene.emitters)));
    HM_TRY(add_table(writes, B::emitter_alias, "emitter choice", bytes_of(scene.emitter_alias)));
    HM_TRY(add_table(writes, B::environment_texels, "environment texels",
                     bytes_of(scene.environment.texels)));
    return add_table(writes, B::environment_alias, "environment choice",
                     bytes_of(scene.environment.alias));
}

Result<void> GpuScene::upload_constants(rhi::DescriptorWrites& writes) {
    using B = SceneBinding;
    const ShadingTables& constant = shading_tables();
    const FrameData frame{};
    const std::array<float, 257> filter{};
    HM_TRY(add_table(writes, B::frame, "frame", bytes_of(std::span(&frame, 1))));
    HM_TRY(add_table(writes, B::filter_table, "filter", bytes_of(filter)));
    HM_TRY(add_table(writes, B::sobol_nibbles, "Sobol nibbles", bytes_of(constant.sobol_nibbles)));
    HM_TRY(add_table(writes, B::blue_noise, "blue noise", bytes_of(constant.blue_noise)));
    HM_TRY(add_table(writes, B::albedo_table, "albedo", bytes_of(constant.albedo_table)));
    HM_TRY(add_table(writes, B::albedo_average, "mean albedo", bytes_of(constant.albedo_average)));
    HM_TRY_ASSIGN(sobol_directions_,
                  rhi::upload_buffer(uploader_, device_,
                                     {"Sobol directions", sizeof(constant.sobol_directions)},
                                     bytes_of(constant.sobol_directions)));
    return {};
}

Result<std::unique_ptr<GpuScene>> GpuScene::create(rhi::Device& device, const SceneLayouts& layouts,
                                                   const FlatScene& scene) {
    HM_TRY(check_memory(device, scene));
    const auto start = std::chrono::steady_clock::now();
    HM_TRY_ASSIGN(rhi::Uploader uploader, rhi::Uploader::create(device));
    std::unique_ptr<GpuScene> gpu(new GpuScene(device, std::move(uploader)));
    gpu->environment_ = scene.environment.data;
    HM_TRY_ASSIGN(gpu->geometry_, GpuGeometry::upload(device, gpu->uploader_, scene));
    HM_TRY_ASSIGN(gpu->textures_,
                  GpuTextures::upload(device, gpu->uploader_, layouts.textures, scene));
    rhi::DescriptorWrites writes(layouts.scene);
    HM_TRY(gpu->upload_tables(scene, writes));
    HM_TRY(gpu->upload_constants(writes));
    HM_TRY(gpu->uploader_.finish());
    gpu->report_.upload_seconds = seconds_since(start);

    const auto build_start = std::chrono::steady_clock::now();
    HM_TRY_ASSIGN(gpu->structures_,
                  SceneStructures::build(device, gpu->uploader_, scene, gpu->geometry_));
    gpu->report_.build_seconds = seconds_since(build_start);
    writes.acceleration_structure(std::uint32_t(SceneBinding::structure), gpu->structures_.tlas);
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

Result<void> GpuScene::set_frame(const RenderParams& params, const CameraData& camera,
                                 std::span<const float> filter_table) {
    HM_CHECK(filter_table.size() == 257, "{} entries", filter_table.size());
    const FrameData frame{params, camera, environment_};
    HM_TRY(uploader_.buffer(tables_[std::size_t(SceneBinding::frame)],
                            bytes_of(std::span(&frame, 1))));
    HM_TRY(
        uploader_.buffer(tables_[std::size_t(SceneBinding::filter_table)], bytes_of(filter_table)));
    return uploader_.finish();
}

}  // namespace hm
