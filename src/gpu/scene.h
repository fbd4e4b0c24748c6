// A scene in device memory: its tables (set 0), textures (set 1) and acceleration structures.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "film/renderer.h"
#include "gpu/geometry.h"
#include "gpu/layouts.h"
#include "gpu/structures.h"
#include "gpu/textures.h"

namespace hm {

struct GpuSceneReport {
    std::uint64_t geometry_bytes = 0;
    std::uint64_t texture_bytes = 0;
    std::uint64_t table_bytes = 0;
    std::uint64_t structure_bytes = 0;
    std::uint64_t triangles = 0;
    std::uint64_t degenerate_triangles = 0;
    std::uint32_t instances = 0;  // in the acceleration structure
    std::uint32_t duplicate_instances = 0;
    double upload_seconds = 0;  // of all but the structures
    double build_seconds = 0;   // of the structures, compaction included
    rhi::BuildReport build;
};

class GpuScene {
  public:
    // If the scene does not fit the device, the error says how much memory it needs. `scene` is not
    // used afterwards.
    static Result<std::unique_ptr<GpuScene>> create(rhi::Device& device,
                                                    const SceneLayouts& layouts,
                                                    const FlatScene& scene);

    // What the next launches read; none may be running.
    Result<void> set_frame(const RenderJob& job);

    const rhi::DescriptorSet& scene_set() const { return set_; }
    const rhi::DescriptorSet& texture_set() const { return textures_.set(); }
    const GpuSceneReport& report() const { return report_; }
    bool has_extended_materials() const { return has_extended_materials_; }

  private:
    GpuScene(rhi::Device& device, rhi::Uploader uploader);
    Result<void> upload_tables(const FlatScene& scene, rhi::DescriptorWrites& writes);
    Result<void> add_table(rhi::DescriptorWrites& writes, std::uint32_t binding, const char* name,
                           std::span<const std::byte> bytes);

    rhi::Device& device_;
    EnvironmentData environment_{};
    bool has_extended_materials_ = false;
    GpuGeometry geometry_;
    GpuTextures textures_;
    SceneStructures structures_;
    std::vector<rhi::Buffer> tables_;  // by binding; empty for the acceleration structure
    rhi::DescriptorSet set_;
    GpuSceneReport report_;
    rhi::Uploader uploader_;  // goes first, and waits: it copies into the others
};

}  // namespace hm
