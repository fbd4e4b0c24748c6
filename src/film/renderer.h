// What draws samples into a film. The CPU and the GPU both do, and the program knows nothing else
// of them.
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

// Live while rendering, for progress reports.
struct RenderCounters {
    std::atomic<std::uint64_t> samples{0};
    std::atomic<std::uint64_t> rays{0};
    std::atomic<std::uint64_t> non_finite{0};  // samples that were not numbers: counted as black
};

// One picture: all that decides its pixels beside the scene and the film's crop.
struct RenderJob {
    CameraData camera{};
    RenderParams params{};
    std::array<float, 257> filter_table{};  // make_filter_table (shading/tables)
    CameraData next_camera{};  // at the next frame: for motion vectors of scenes that move
};

// What a renderer tells of itself and of the scene it holds.
struct RendererReport {
    std::string kind;                   // "cpu" or "vulkan"
    std::string device;                 // what decides a picture's bits: "CPU", "NVIDIA H200"
    std::string variant;                // the instruction set, or the driver and its version
    double upload_seconds = 0;          // copying the scene to the device
    double build_seconds = 0;           // the acceleration structure
    double trace_seconds = 0;           // drawing, by the device's own clock; 0 where it has none
    std::uint64_t structure_bytes = 0;  // of the acceleration structure
    std::uint64_t device_bytes = 0;     // all that the scene and the film take there
    // How several samples of a pixel are drawn, where that is measured meanwhile; empty before.
    std::string launches{};
    // What the acceleration structure consists of, by name: {"triangles", 32}.
    std::vector<std::pair<std::string, std::uint64_t>> structure{};
};

// What the stages are told of the AOVs. `moves`: the scene has tables of its next frame.
AovParams aov_params(const AovSelection& selection, const RenderJob& job, bool moves);

class Renderer {
  public:
    virtual ~Renderer() = default;

    // What renders, for people: "CPU (avx512)".
    virtual std::string device() const = 0;

    // From now on samples go to `film`, on top of what it holds. The film is borrowed until the
    // next begin or the renderer's end.
    virtual Result<void> begin(const RenderJob& job, Film& film) = 0;

    // Adds samples [begin, end) to each pixel of the film, in the order of their indices: the same
    // bits however a range is split. Returns early once `cancel` is set: a GPU after whole samples
    // of all pixels, the CPU after whole tiles, which leaves pixels with fewer samples. The same
    // range once more finishes it there: a pixel that has some of the samples, by its weight, gets
    // the others. Fails where the device does.
    virtual Result<void> render(std::uint32_t begin, std::uint32_t end, RenderCounters& counters,
                                const std::atomic<bool>& cancel) = 0;

    // Brings the film's sums up to date: a device with memory of its own keeps them until then.
    virtual Result<void> sync() = 0;

    virtual RendererReport report() const = 0;
};

}  // namespace hm
