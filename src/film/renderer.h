// The interface of a renderer, which adds samples to a film. The CPU and the GPU renderer implement
// it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "film/film.h"
#include "shading/structs.h"

namespace hm {

// Updated while rendering, for progress reports.
struct RenderCounters {
    std::atomic<std::uint64_t> samples{0};
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> non_finite{0};  // samples with NaN or infinity, which count as black
};

// One picture: everything that determines its pixels except the scene and the film's crop.
struct RenderJob {
    CameraData camera{};
    RenderParams params{};
    std::array<float, 257> filter_table{};  // make_filter_table (shading/tables)
    CameraData next_camera{};  // at the next frame, for motion vectors of animated scenes
};

// What a renderer reports about itself and its scene.
struct RendererReport {
    std::string kind;                   // "cpu" or "vulkan"
    std::string device;                 // determines a picture's bits: "CPU", "NVIDIA H200"
    std::string variant;                // the instruction set, or the driver and its version
    double upload_seconds = 0;          // copying the scene to the device
    double build_seconds = 0;           // the acceleration structure
    double trace_seconds = 0;           // tracing, by the device's own clock; 0 if it has none
    std::uint64_t structure_bytes = 0;  // of the acceleration structure
    std::uint64_t device_bytes = 0;     // of the scene and the film in device memory
    // How several samples per pixel are launched, if the renderer measures and chooses that while
    // rendering; empty until then.
    std::string launches{};
    // Contents of the acceleration structure: {"triangles", 32}.
    std::vector<std::pair<std::string, std::uint64_t>> structure{};
};

// The AOV parameters passed to the stages. `moves`: the scene has tables of its next frame.
AovParams aov_params(const AovSelection& selection, const RenderJob& job, bool moves);

class Renderer {
  public:
    virtual ~Renderer() = default;

    // A readable name: "CPU (avx512)".
    virtual std::string device() const = 0;

    // Adds the following samples to `film`, which may already hold some. The film must outlive the
    // renderer or the next call of begin.
    virtual Result<void> begin(const RenderJob& job, Film& film) = 0;

    // Adds samples [begin, end) to each pixel of the film in index order, so that splitting a range
    // does not change a bit. Returns early once `cancel` is set: a GPU after whole samples of all
    // pixels, the CPU after whole tiles, which leaves some pixels with fewer samples. Rendering the
    // same range again completes it: each pixel gets the samples that its weight shows to be
    // missing. Fails if the device fails.
    virtual Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                                const std::atomic<bool>& cancel) = 0;

    // Copies the sums to the film if the device keeps them in its own memory.
    virtual Result<void> sync() = 0;

    virtual RendererReport report() const = 0;
};

}  // namespace hm
