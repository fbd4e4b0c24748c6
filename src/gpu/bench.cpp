#include "gpu/bench.h"

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "gpu/batches.h"
#include "rhi/query.h"

namespace hm {
namespace {

constexpr std::uint32_t kMaxEvents = 32;

using Record = std::function<void(rhi::Commands&)>;

Result<double> timed_ms(rhi::Device& device, rhi::Timestamps& timestamps, const Record& record) {
    HM_TRY(rhi::run_once(device, "bench", [&](rhi::Commands& commands) -> Result<void> {
        timestamps.reset(commands);
        timestamps.write(commands, 0);
        record(commands);
        timestamps.write(commands, 1);
        return {};
    }));
    HM_TRY_ASSIGN(const std::vector<double> ms, timestamps.milliseconds(2));
    return ms[1];
}

// The median of the device's milliseconds for one run of what `record` records. The runs before
// are not counted: an idle card's clock takes some time to rise (measured: a fourth of the rate for
// the first 0.3 s), and the card is idle while a pipeline compiles.
Result<double> median_ms(rhi::Device& device, std::uint32_t repeats, const Record& record) {
    constexpr double kWarmMilliseconds = 500;
    HM_TRY_ASSIGN(rhi::Timestamps timestamps, rhi::Timestamps::create(device, "bench", 2));
    for (double warm = 0; warm < kWarmMilliseconds;) {
        HM_TRY_ASSIGN(const double ms, timed_ms(device, timestamps, record));
        warm += std::max(ms, 1.0);
    }
    std::vector<double> times;
    for (std::uint32_t i = 0; i < repeats; ++i) {
        HM_TRY_ASSIGN(const double ms, timed_ms(device, timestamps, record));
        times.push_back(ms);
    }
    std::nth_element(times.begin(), times.begin() + std::ptrdiff_t(times.size() / 2), times.end());
    return times.empty() ? 0.0 : times[times.size() / 2];
}

// What the path tracer writes, in layout general; the earlier contents do not matter.
struct Scratch {
    rhi::Image accumulation;
    rhi::Image removed;
    rhi::Buffer counters;

    static Result<Scratch> create(rhi::Device& device, std::uint32_t width, std::uint32_t height) {
        Scratch s;
        const rhi::ImageUse use = rhi::ImageUse::storage;
        HM_TRY_ASSIGN(s.accumulation,
                      rhi::Image::create(
                          device, {"bench sums", rhi::Format::rgba32f, width, height, 1, use}));
        HM_TRY_ASSIGN(s.removed, rhi::Image::create(device, {"bench removed", rhi::Format::r32f,
                                                             width, height, 1, use}));
        HM_TRY_ASSIGN(
            s.counters,
            rhi::Buffer::create(device, {"bench counters", kCounterRows * sizeof(TraceCounters)}));
        HM_TRY(rhi::run_once(device, "bench", [&](rhi::Commands& commands) -> Result<void> {
            for (const rhi::Image* image : {&s.accumulation, &s.removed}) {
                commands.transition(*image, rhi::ImageLayout::undefined, rhi::ImageLayout::general);
                commands.clear(*image, rhi::ImageLayout::general, 0);
            }
            commands.fill(s.counters, 0);
            return {};
        }));
        return s;
    }
};

Result<void> count_rays(rhi::Device& device, const RecordedRays& rays, TraceRates& rates) {
    std::vector<RecordedCounts> counts(rays.counts.size() / sizeof(RecordedCounts));
    HM_TRY(rhi::read_back(device, rays.counts, std::as_writable_bytes(std::span(counts))));
    for (const RecordedCounts& c : counts) {
        rates.shadow_rays += c.shadow_rays;
        rates.closest_rays += c.rays - c.shadow_rays;
    }
    return {};
}

// Samples [0, count) of a picture.
TraceRange first_samples(std::uint32_t count) {
    TraceRange range{};
    range.sample_end = count;
    return range;
}

// How several samples of each pixel may be launched.
constexpr std::pair<const char*, Launches> kWays[] = {{"launches", Launches::one_per_sample},
                                                      {"loop", Launches::loop}};

// As many samples as one of the renderer's batches.
Result<void> measure_ways(GpuContext& context, const GpuScene& scene, const Scratch& scratch,
                          const RenderParams& params, std::uint32_t repeats, TraceRates& rates) {
    rates.several = std::uint32_t(std::clamp(kBatchMilliseconds / rates.path_ms, 2.0, 16.0));
    const TraceRange range = first_samples(rates.several);
    const std::uint32_t height = scratch.accumulation.info().height;
    HM_TRY_ASSIGN(const PathTracingPass* paths,
                  context.path_tracing({.settings = settings_of(params),
                                        .extended = scene.has_extended_materials()}));
    for (const auto& way : kWays) {
        const auto record = [&](rhi::Commands& commands) {
            paths->record(commands, scene,
                          {scratch.accumulation, scratch.removed, scratch.counters}, range, height,
                          way.second);
        };
        HM_TRY_ASSIGN(const double ms, median_ms(context.device(), repeats, record));
        rates.ways.emplace_back(way.first, ms / rates.several);
    }
    return {};
}

}  // namespace

Result<TraceRates> measure_tracing(GpuContext& context, GpuScene& scene, const RenderJob& job,
                                   bool reorder, std::uint32_t repeats) {
    rhi::Device& device = context.device();
    const std::uint32_t width = job.params.width;
    const std::uint32_t height = job.params.height;
    RenderJob bounded = job;
    RenderParams& params = bounded.params;
    params.max_bounces =
        params.max_bounces == 0 ? kMaxEvents : std::min(params.max_bounces, kMaxEvents);
    HM_TRY(scene.set_frame(bounded));
    HM_TRY_ASSIGN(const Scratch scratch, Scratch::create(device, width, height));
    HM_TRY_ASSIGN(const RecordedRays rays,
                  RecordedRays::create(device, width * height, 2 * params.max_bounces + 2));
    const TraceRange first_sample = first_samples(1);

    TraceRates rates;
    HM_TRY_ASSIGN(
        const PathTracingPass* recorder,
        context.path_tracing({.record = true, .extended = scene.has_extended_materials()}));
    HM_TRY(rhi::run_once(device, "record rays", [&](rhi::Commands& commands) -> Result<void> {
        recorder->record(
            commands, scene,
            {scratch.accumulation, scratch.removed, scratch.counters, &rays.rays, &rays.counts},
            first_sample, height);
        return {};
    }));
    HM_TRY(count_rays(device, rays, rates));

    HM_TRY_ASSIGN(const PathTracingPass* paths,
                  context.path_tracing({.settings = settings_of(params),
                                        .reorder = reorder,
                                        .extended = scene.has_extended_materials()}));
    HM_TRY_ASSIGN(rates.path_ms, median_ms(device, repeats, [&](rhi::Commands& commands) {
                      paths->record(commands, scene,
                                    {scratch.accumulation, scratch.removed, scratch.counters},
                                    first_sample, height);
                  }));
    HM_TRY(measure_ways(context, scene, scratch, params, repeats, rates));
    HM_TRY_ASSIGN(const BareTracePass* bare, context.bare_trace());
    const auto bare_ms = [&](std::uint32_t kinds, std::uint32_t depth) {
        return median_ms(device, repeats, [&, kinds, depth](rhi::Commands& commands) {
            bare->record(commands, scene, rays, kinds, width, height, depth);
        });
    };
    const std::uint32_t both = kRecordedClosest | kRecordedShadow;
    HM_TRY_ASSIGN(rates.bare_ms, bare_ms(both, rays.rays_per_pixel));
    HM_TRY_ASSIGN(rates.bare_closest_ms, bare_ms(kRecordedClosest, rays.rays_per_pixel));
    HM_TRY_ASSIGN(rates.bare_shadow_ms, bare_ms(kRecordedShadow, rays.rays_per_pixel));
    HM_TRY_ASSIGN(rates.bare_loop_ms, bare_ms(both, 1));
    return rates;
}

}  // namespace hm
