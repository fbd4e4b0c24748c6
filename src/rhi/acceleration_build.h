// Builds acceleration structures: bottom-level ones over triangles, in batches that share scratch
// memory, then compacted; top-level ones over instances.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "rhi/acceleration_structure.h"
#include "rhi/device.h"

namespace hm::rhi {

// Triangles in buffers with BufferUse build_input, by device address. A position is three floats;
// each triangle has three std::uint32_t indices.
struct TriangleGeometry {
    std::uint64_t positions = 0;
    std::uint64_t position_stride = 12;  // bytes
    std::uint32_t vertex_count = 0;
    std::uint64_t indices = 0;
    std::uint32_t triangle_count = 0;
    bool opaque = true;           // false: any-hit shaders run, at most once per hit
    std::uint64_t transform = 0;  // three rows of four floats, applied while building; 0: none
};

struct BlasInput {
    std::string name;
    std::vector<TriangleGeometry> geometries;
};

struct BuildOptions {
    std::uint64_t scratch_budget_bytes = 256u << 20;  // a single larger build gets what it needs
    bool compact = true;
};

struct BuildReport {
    std::uint32_t structures = 0;
    std::uint32_t batches = 0;
    std::uint64_t built_bytes = 0;    // before compaction
    std::uint64_t kept_bytes = 0;     // after compaction
    std::uint64_t scratch_bytes = 0;  // peak
    double gpu_ms = 0;                // building and compacting; 0 if there are no timestamps

    void add(const BuildReport& other);
};

// In the order of `inputs`. Waits until they are built.
Result<std::vector<AccelerationStructure>> build_blas(Device& device,
                                                      std::span<const BlasInput> inputs,
                                                      const BuildOptions& options,
                                                      BuildReport& report);

struct TlasInstance {
    std::array<float, 12> transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};  // rows of object to world
    std::uint32_t custom_index = 0;  // 24 bits: gl_InstanceCustomIndexEXT
    std::uint8_t mask = 0xff;
    std::uint64_t blas = 0;  // AccelerationStructure::address
};

// Facing culling is disabled for all instances. Waits until the structure is built. Every ray
// misses a structure without instances.
Result<AccelerationStructure> build_tlas(Device& device, const std::string& name,
                                         std::span<const TlasInstance> instances,
                                         BuildReport& report);

}  // namespace hm::rhi
