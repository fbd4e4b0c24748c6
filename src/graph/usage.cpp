#include "graph/usage.h"

#include "base/check.h"

namespace hm::graph {

namespace {

constexpr std::uint64_t kStorageReads =
    VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT;

// The pipeline stages of a kind of pass, and the access flags for reads and writes there.
struct Kinds {
    std::uint64_t stages, reads, writes;
};

Kinds kinds_of(PassKind pass) {
    switch (pass) {
        case PassKind::compute:
            break;
        case PassKind::trace:
            return {VK_PIPELINE_STAGE_2_RAY_TRACING_SHADER_BIT_KHR,
                    kStorageReads | VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR,
                    VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
        case PassKind::copy:
            return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                    VK_ACCESS_2_TRANSFER_WRITE_BIT};
        case PassKind::build:
            // Vertices, indices and instances count as read by a shader.
            return {VK_PIPELINE_STAGE_2_ACCELERATION_STRUCTURE_BUILD_BIT_KHR,
                    VK_ACCESS_2_SHADER_READ_BIT | VK_ACCESS_2_ACCELERATION_STRUCTURE_READ_BIT_KHR,
                    VK_ACCESS_2_ACCELERATION_STRUCTURE_WRITE_BIT_KHR};
    }
    return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, kStorageReads,
            VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
}

rhi::ImageLayout layout_of(PassKind pass, AccessKind access) {
    if (access == AccessKind::sample) return rhi::ImageLayout::shader_read;
    if (pass != PassKind::copy) return rhi::ImageLayout::general;
    return writes(access) ? rhi::ImageLayout::transfer_target : rhi::ImageLayout::transfer_source;
}

}  // namespace

Usage usage_of(PassKind pass, AccessKind access) {
    const Kinds kinds = kinds_of(pass);
    Usage usage{{kinds.stages, 0}, layout_of(pass, access)};
    if (access == AccessKind::sample) {
        HM_CHECK(pass == PassKind::compute || pass == PassKind::trace,
                 "a pass of kind {} samples nothing", static_cast<int>(pass));
        usage.scope.access = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
        return usage;
    }
    if (reads(access)) usage.scope.access |= kinds.reads;
    if (writes(access)) usage.scope.access |= kinds.writes;
    return usage;
}

}  // namespace hm::graph
