#include "rhi/acceleration_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/check.h"

namespace hm::rhi {

std::uint64_t scratch_alignment(const Device& device) {
    return std::max(1u,
                    device.acceleration_limits().minAccelerationStructureScratchOffsetAlignment);
}

namespace {

void ask_sizes(const Device& device, Build& build) {
    std::vector<std::uint32_t> counts;
    for (const VkAccelerationStructureBuildRangeInfoKHR& range : build.ranges)
        counts.push_back(range.primitiveCount);
    const VkAccelerationStructureBuildGeometryInfoKHR info = build.info();
    VkAccelerationStructureBuildSizesInfoKHR sizes{
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
    vkGetAccelerationStructureBuildSizesKHR(device.handle(),
                                            VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info,
                                            counts.data(), &sizes);
    const std::uint64_t alignment = scratch_alignment(device);
    build.structure_bytes = sizes.accelerationStructureSize;
    build.scratch_bytes = (sizes.buildScratchSize + alignment - 1) / alignment * alignment;
}

VkAccelerationStructureGeometryKHR describe_triangles(const TriangleGeometry& geometry) {
    VkAccelerationStructureGeometryKHR described{
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR,
        .geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR,
        .flags = geometry.opaque
                     ? VkGeometryFlagsKHR{VK_GEOMETRY_OPAQUE_BIT_KHR}
                     : VkGeometryFlagsKHR{VK_GEOMETRY_NO_DUPLICATE_ANY_HIT_INVOCATION_BIT_KHR}};
    described.geometry.triangles = {
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR,
        .vertexFormat = VK_FORMAT_R32G32B32_SFLOAT,
        .vertexData = {.deviceAddress = geometry.positions},
        .vertexStride = geometry.position_stride,
        .maxVertex = geometry.vertex_count > 0 ? geometry.vertex_count - 1 : 0,
        .indexType = VK_INDEX_TYPE_UINT32,
        .indexData = {.deviceAddress = geometry.indices},
        .transformData = {.deviceAddress = geometry.transform}};
    return described;
}

}  // namespace

Result<Build> plan_blas(const Device& device, const BlasInput& input, bool compact) {
    Build build;
    build.name = input.name;
    if (compact) build.flags |= VK_BUILD_ACCELERATION_STRUCTURE_ALLOW_COMPACTION_BIT_KHR;
    std::uint64_t triangles = 0;
    for (const TriangleGeometry& geometry : input.geometries) {
        build.geometries.push_back(describe_triangles(geometry));
        build.ranges.push_back({.primitiveCount = geometry.triangle_count});
        triangles += geometry.triangle_count;
    }
    const Limits& limits = device.limits();
    if (triangles > limits.max_triangles || input.geometries.size() > limits.max_geometries)
        return fail(
            ErrorKind::device_failed, "Vulkan", input.name,
            fmt::format("{} triangles in {} geometries; the device supports {} in {}", triangles,
                        input.geometries.size(), limits.max_triangles, limits.max_geometries));
    ask_sizes(device, build);
    return build;
}

Result<Buffer> upload_instances(Device& device, const std::string& name,
                                std::span<const TlasInstance> instances) {
    // The build reads it only once, so device memory would gain nothing.
    HM_TRY_ASSIGN(Buffer buffer,
                  Buffer::create(device, {.name = name + ": instances",
                                          .size = std::max<std::uint64_t>(instances.size(), 1) *
                                                  sizeof(VkAccelerationStructureInstanceKHR),
                                          .use = BufferUse::build_input,
                                          .memory = MemoryKind::upload,
                                          .alignment = 16}));
    std::byte* target = buffer.mapped().data();
    for (const TlasInstance& instance : instances) {
        HM_CHECK(instance.custom_index < (1u << 24), "custom index {}", instance.custom_index);
        VkAccelerationStructureInstanceKHR record{};
        static_assert(sizeof(record.transform) == sizeof(instance.transform));
        std::memcpy(&record.transform, instance.transform.data(), sizeof(record.transform));
        record.instanceCustomIndex = instance.custom_index & 0xffffffu;
        record.mask = instance.mask;
        record.flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
        record.accelerationStructureReference = instance.blas;
        std::memcpy(target, &record, sizeof(record));
        target += sizeof(record);
    }
    return buffer;
}

Build plan_tlas(const Device& device, const std::string& name, std::uint64_t address,
                std::uint32_t count) {
    Build build;
    build.name = name;
    build.type = VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR;
    VkAccelerationStructureGeometryKHR geometry{
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR,
        .geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR};
    geometry.geometry.instances = {
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR,
        .data = {.deviceAddress = address}};
    build.geometries.push_back(geometry);
    build.ranges.push_back({.primitiveCount = count});
    ask_sizes(device, build);
    return build;
}

}  // namespace hm::rhi
