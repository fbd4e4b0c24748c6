#include "rhi/acceleration_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "rhi/acceleration_inputs.h"
#include "rhi/commands.h"
#include "rhi/error.h"
#include "rhi/query.h"

namespace hm::rhi {

namespace {

// The end of the batch of builds from `begin` whose scratch memory fits in the budget together.
std::size_t end_of_batch(std::span<const Build> builds, std::size_t begin, std::uint64_t budget) {
    std::uint64_t scratch = builds[begin].scratch_bytes;
    std::size_t end = begin + 1;
    while (end < builds.size() && scratch + builds[end].scratch_bytes <= budget)
        scratch += builds[end++].scratch_bytes;
    return end;
}

std::uint64_t scratch_of(std::span<const Build> batch) {
    std::uint64_t bytes = 0;
    for (const Build& build : batch)
        bytes += build.scratch_bytes;
    return bytes;
}

// Records all builds of a batch, each with its own part of the scratch buffer.
void record_builds(Commands& commands, std::span<const Build> batch,
                   std::span<const AccelerationStructure> targets, const Buffer& scratch) {
    std::vector<VkAccelerationStructureBuildGeometryInfoKHR> infos;
    std::vector<const VkAccelerationStructureBuildRangeInfoKHR*> ranges;
    std::uint64_t address = scratch.address();
    for (std::size_t i = 0; i < batch.size(); ++i) {
        infos.push_back(batch[i].info());
        infos.back().dstAccelerationStructure = targets[i].handle();
        infos.back().scratchData.deviceAddress = address;
        ranges.push_back(batch[i].ranges.data());
        address += batch[i].scratch_bytes;
    }
    vkCmdBuildAccelerationStructuresKHR(commands.handle(), static_cast<std::uint32_t>(infos.size()),
                                        infos.data(), ranges.data());
}

using QueryPool = Handle<VkQueryPool, &vkDestroyQueryPool>;

Result<QueryPool> make_size_queries(const Device& device, std::uint32_t count) {
    const VkQueryPoolCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
        .queryType = VK_QUERY_TYPE_ACCELERATION_STRUCTURE_COMPACTED_SIZE_KHR,
        .queryCount = count};
    VkQueryPool pool = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool),
                        "vkCreateQueryPool", "compacted sizes"));
    return QueryPool(device.handle(), pool);
}

// Runs `record` between two timestamps and adds the time to the report.
Result<void> run_timed(Device& device, std::string_view name, BuildReport& report,
                       const std::function<void(Commands&)>& record) {
    HM_TRY_ASSIGN(Timestamps times, Timestamps::create(device, name, 2));
    HM_TRY(run_once(device, name, [&](Commands& commands) -> Result<void> {
        times.reset(commands);
        // The inputs may have been written by any stage.
        commands.full_barrier();
        times.write(commands, 0);
        record(commands);
        times.write(commands, 1);
        return {};
    }));
    HM_TRY_ASSIGN(const std::vector<double> ms, times.milliseconds(2));
    report.gpu_ms += ms[1];
    return {};
}

Result<std::vector<AccelerationStructure>> build_batch(Device& device, std::span<const Build> batch,
                                                       const Buffer& scratch, VkQueryPool sizes,
                                                       BuildReport& report) {
    std::vector<AccelerationStructure> built;
    std::vector<VkAccelerationStructureKHR> handles;
    for (const Build& build : batch) {
        HM_TRY_ASSIGN(
            AccelerationStructure structure,
            AccelerationStructure::allocate(device, build.name, build.type, build.structure_bytes));
        report.built_bytes += structure.bytes();
        handles.push_back(structure.handle());
        built.push_back(std::move(structure));
    }
    const auto count = static_cast<std::uint32_t>(batch.size());
    HM_TRY(run_timed(device, "build acceleration structures", report, [&](Commands& commands) {
        record_builds(commands, batch, built, scratch);
        if (sizes == VK_NULL_HANDLE) return;
        vkCmdResetQueryPool(commands.handle(), sizes, 0, count);
        commands.full_barrier();
        vkCmdWriteAccelerationStructuresPropertiesKHR(
            commands.handle(), count, handles.data(),
            VK_QUERY_TYPE_ACCELERATION_STRUCTURE_COMPACTED_SIZE_KHR, sizes, 0);
    }));
    ++report.batches;
    return built;
}

// Compacts each structure: copies it to a new one of its compacted size.
Result<std::vector<AccelerationStructure>> compact_batch(
    Device& device, std::span<const Build> batch, std::span<const AccelerationStructure> built,
    VkQueryPool queries, BuildReport& report) {
    std::vector<std::uint64_t> sizes(batch.size());
    HM_TRY(device.check(
        vkGetQueryPoolResults(device.handle(), queries, 0, static_cast<std::uint32_t>(sizes.size()),
                              sizes.size() * sizeof(std::uint64_t), sizes.data(),
                              sizeof(std::uint64_t),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults", "compacted sizes"));
    std::vector<AccelerationStructure> compacted;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        HM_TRY_ASSIGN(
            AccelerationStructure structure,
            AccelerationStructure::allocate(device, batch[i].name, batch[i].type, sizes[i]));
        compacted.push_back(std::move(structure));
    }
    HM_TRY(run_timed(device, "compact acceleration structures", report, [&](Commands& commands) {
        for (std::size_t i = 0; i < batch.size(); ++i) {
            const VkCopyAccelerationStructureInfoKHR copy{
                .sType = VK_STRUCTURE_TYPE_COPY_ACCELERATION_STRUCTURE_INFO_KHR,
                .src = built[i].handle(),
                .dst = compacted[i].handle(),
                .mode = VK_COPY_ACCELERATION_STRUCTURE_MODE_COMPACT_KHR};
            vkCmdCopyAccelerationStructureKHR(commands.handle(), &copy);
        }
    }));
    return compacted;
}

Result<Buffer> make_scratch(Device& device, std::uint64_t bytes) {
    return Buffer::create(device, {.name = "acceleration structure scratch",
                                   .size = std::max<std::uint64_t>(bytes, 1),
                                   .use = BufferUse::storage,
                                   .alignment = scratch_alignment(device)});
}

}  // namespace

void BuildReport::add(const BuildReport& other) {
    structures += other.structures;
    batches += other.batches;
    built_bytes += other.built_bytes;
    kept_bytes += other.kept_bytes;
    scratch_bytes = std::max(scratch_bytes, other.scratch_bytes);
    gpu_ms += other.gpu_ms;
}

Result<std::vector<AccelerationStructure>> build_blas(Device& device,
                                                      std::span<const BlasInput> inputs,
                                                      const BuildOptions& options,
                                                      BuildReport& report) {
    std::vector<AccelerationStructure> all;
    if (inputs.empty()) return all;
    std::vector<Build> builds;
    for (const BlasInput& input : inputs) {
        HM_TRY_ASSIGN(Build build, plan_blas(device, input, options.compact));
        builds.push_back(std::move(build));
    }
    std::vector<std::span<const Build>> batches;
    std::uint64_t scratch_bytes = 0;
    std::size_t largest = 0;
    for (std::size_t begin = 0; begin < builds.size();) {
        const std::size_t end = end_of_batch(builds, begin, options.scratch_budget_bytes);
        batches.push_back(std::span<const Build>(builds).subspan(begin, end - begin));
        scratch_bytes = std::max(scratch_bytes, scratch_of(batches.back()));
        largest = std::max(largest, end - begin);
        begin = end;
    }
    HM_TRY_ASSIGN(const Buffer scratch, make_scratch(device, scratch_bytes));
    report.scratch_bytes = std::max(report.scratch_bytes, scratch.size());
    QueryPool sizes;
    if (options.compact) {
        HM_TRY_ASSIGN(sizes, make_size_queries(device, static_cast<std::uint32_t>(largest)));
    }
    // A batch is compacted before the next is built, so only one exists in full size at a time.
    for (const std::span<const Build> batch : batches) {
        HM_TRY_ASSIGN(std::vector<AccelerationStructure> done,
                      build_batch(device, batch, scratch, sizes.get(), report));
        if (options.compact) {
            HM_TRY_ASSIGN(done, compact_batch(device, batch, done, sizes.get(), report));
        }
        for (AccelerationStructure& structure : done) {
            report.kept_bytes += structure.bytes();
            ++report.structures;
            all.push_back(std::move(structure));
        }
    }
    return all;
}

Result<AccelerationStructure> build_tlas(Device& device, const std::string& name,
                                         std::span<const TlasInstance> instances,
                                         BuildReport& report) {
    if (instances.size() > device.limits().max_instances)
        return fail(ErrorKind::device_failed, "Vulkan", name,
                    fmt::format("{} instances; the device supports {}", instances.size(),
                                device.limits().max_instances));
    HM_TRY_ASSIGN(const Buffer buffer, upload_instances(device, name, instances));
    const Build build =
        plan_tlas(device, name, buffer.address(), static_cast<std::uint32_t>(instances.size()));
    HM_TRY_ASSIGN(const Buffer scratch, make_scratch(device, build.scratch_bytes));
    report.scratch_bytes = std::max(report.scratch_bytes, scratch.size());
    HM_TRY_ASSIGN(std::vector<AccelerationStructure> built,
                  build_batch(device, std::span(&build, 1), scratch, VK_NULL_HANDLE, report));
    report.kept_bytes += built.front().bytes();
    ++report.structures;
    return std::move(built.front());
}

}  // namespace hm::rhi
