// The Vulkan device that the tests draw with, and pictures of one scene by both renderers.
#pragma once

#include <memory>
#include <string>

#include "cpu/render.h"
#include "gpu/renderer.h"
#include "gpu/same_picture.h"

namespace hm::test {

// Made once for all tests of a program, with validation: its pipelines take a minute to compile on
// a software device. HIMALAYA_TEST_DEVICE=N selects vulkan:N; otherwise the best device, or the
// first one.
GpuContext& gpu_context();

// Fails if the validation layer has reported anything since the last call.
void expect_no_messages();

// 64 x 64 pixels, 16 samples, Sobol with Owen scrambling, 6 bounces.
RenderJob make_job(const FlatScene& scene, const CameraData& camera);

inline constexpr std::uint32_t kPictureSize = 64;
inline constexpr std::uint32_t kPictureSamples = 16;

// Samples 0 to kPictureSamples of the film's or the given crop, in one go.
void draw_into(Renderer& renderer, const RenderJob& job, Film& film);
Film draw(Renderer& renderer, const RenderJob& job, PixelRect crop);
Film draw(Renderer& renderer, const RenderJob& job);

// One scene on both devices. Not copied: the renderers point into it.
class Duel {
  public:
    explicit Duel(const FlatScene& scene);
    Renderer& cpu() { return cpu_; }
    VulkanRenderer& gpu() { return *gpu_; }
    // Expects both pictures of a job to be the same. Returns how many pixels still differ.
    std::size_t expect_parity(const RenderJob& job, const std::string& what);

  private:
    CpuRenderer cpu_;
    std::unique_ptr<VulkanRenderer> gpu_;
};

}  // namespace hm::test
