// Rays and samples per second, and the error over samples of each sampler, as JSON.
//
//     render_bench [--errors] [--aovs] SCENE[:ENVIRONMENT] ...
//
// SCENE is a glTF file; ENVIRONMENT is a .hdr or .exr file, "none", or absent for the default one.
// Rates are per wall-clock second with all cores and per CPU second, which varies less on a busy
// machine. Errors are relative mean squared errors at 96 x 64, averaged over seeds; the reference
// has 4096 samples of Owen-scrambled Sobol with another seed. --aovs: CPU time with each AOV, and
// with all, relative to none; the error with the variance AOV relative to that without it.
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/files.h"
#include "base/json_writer.h"
#include "base/machine.h"
#include "compare/metrics.h"
#include "cpu/render.h"
#include "gltf/load.h"
#include "image/read.h"
#include "scene/camera.h"
#include "scene/light_groups.h"
#include "scene/render_params.h"
#include "shading/tables/tables.h"

namespace hm {
namespace {

struct BenchScene {
    Scene scene;
    FlatScene flat;
    std::size_t camera_node = 0;
    bool has_camera = false;
};

Result<EnvironmentMap> read_environment(const std::string& name) {
    if (name == "none") return make_environment(default_environment(), 0, 0);
    if (name.empty()) return make_environment(default_environment(), 0, 1);
    HM_TRY_ASSIGN(ByteArray bytes, read_file(name));
    ReadWarnings warnings;
    HM_TRY_ASSIGN(FloatImage image, read_environment_image(bytes, name, warnings));
    return make_environment(image, 0, 1);
}

Result<void> load(BenchScene& bench, const std::string& argument) {
    std::size_t colon = argument.find(':');
    std::string environment = colon == std::string::npos ? "" : argument.substr(colon + 1);
    Diagnostics diagnostics;
    HM_TRY_ASSIGN(bench.scene, load_gltf(argument.substr(0, colon), diagnostics));
    HM_TRY_ASSIGN(EnvironmentMap map, read_environment(environment));
    bench.flat = flatten(bench.scene, std::move(map), {}, diagnostics);
    for (std::size_t i = 0; i < bench.scene.nodes.size() && !bench.has_camera; ++i) {
        bench.has_camera = bench.scene.nodes[i].camera != kUnset;
        bench.camera_node = i;
    }
    return {};
}

CameraData camera_of(const BenchScene& bench, float aspect) {
    if (!bench.has_camera) return camera_framing(bench.flat.bounds, 0.8f, aspect);
    const Node& node = bench.scene.nodes[bench.camera_node];
    return camera_from_node(bench.scene.cameras[std::size_t(node.camera)],
                            world_transforms(bench.scene)[bench.camera_node], aspect);
}

struct Settings {
    std::uint32_t width, height, samples, seed, sampler;
    AovSelection aovs{};
};

Film render(const BenchScene& bench, Renderer& renderer, const Settings& settings,
            RenderCounters& counters) {
    const RenderParams params = make_params(
        bench.flat, settings.width, settings.height,
        {.seed = settings.seed, .sampler = settings.sampler, .filter = PixelFilter::box});
    Film film({0, 0, settings.width, settings.height}, settings.aovs);
    std::atomic<bool> cancel{false};
    const float aspect = float(settings.width) / float(settings.height);
    const RenderJob job{camera_of(bench, aspect), params, make_filter_table(PixelFilter::box)};
    const Result<void> drawn = renderer.begin(job, film).and_then(
        [&] { return renderer.render(0, settings.samples, counters, cancel); });
    HM_CHECK(drawn.has_value(), "{}", drawn.error().line());
    return film;
}

void measure_rates(JsonWriter& json, const BenchScene& bench, CpuRenderer& renderer) {
    constexpr std::uint32_t width = 640, height = 360;
    double best_wall = 1e30, best_processor = 1e30, samples = 0, rays = 0;
    for (std::uint32_t repeat = 0; repeat < 3; ++repeat) {
        RenderCounters counters;
        double wall = wall_seconds(), processor = processor_seconds();
        render(bench, renderer, {width, height, 16, 1, kSamplerSobolOwen}, counters);
        best_wall = std::min(best_wall, wall_seconds() - wall);
        best_processor = std::min(best_processor, processor_seconds() - processor);
        samples = double(counters.samples);
        rays = double(counters.rays);
    }
    json.field("samples_per_second", samples / best_wall, 4);
    json.field("rays_per_second", rays / best_wall, 4);
    json.field("samples_per_processor_second", samples / best_processor, 4);
    json.field("rays_per_processor_second", rays / best_processor, 4);
    json.field("rays_per_sample", rays / samples, 4);
}

void measure_errors(JsonWriter& json, const BenchScene& bench, CpuRenderer& renderer) {
    constexpr std::uint32_t width = 96, height = 64;
    constexpr std::string_view names[] = {"independent", "sobol_blue_noise", "sobol_owen"};
    RenderCounters counters;
    const FloatImage reference =
        render(bench, renderer, {width, height, 4096, 999, kSamplerSobolOwen}, counters).resolve();
    json.key("relative_mse").begin_object();
    for (std::uint32_t sampler = 0; sampler < 3; ++sampler) {
        json.key(names[sampler]).begin_object(JsonLayout::compact);
        for (std::uint32_t samples : {1u, 4u, 16u, 64u, 256u}) {
            const std::uint32_t seeds = samples < 64 ? 4 : 2;
            double sum = 0;
            for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
                Film film =
                    render(bench, renderer, {width, height, samples, seed, sampler}, counters);
                sum += compare_images(film.resolve(), reference).relative_mse;
            }
            json.field(std::to_string(samples), sum / seeds, 4);
        }
        json.end_object();
    }
    json.end_object();
}

// The minimum of three rounds; each round measures all choices, so that drift affects all alike.
void measure_aovs(JsonWriter& json, const BenchScene& bench, Renderer& renderer,
                  const std::vector<std::string>& light_groups) {
    std::vector<std::pair<std::string, AovSelection>> choices = {{"none", {}}};
    for (const AovInfo& info : all_aovs())
        choices.push_back({std::string(info.name), {{info.aov}, {}, false}});
    choices.push_back({"all", {*parse_aovs("all,variance"), {}, false}});
    std::vector<double> best(choices.size(), 1e30);
    for (int round = 0; round < 3; ++round)
        for (std::size_t i = 0; i < choices.size(); ++i) {
            RenderCounters counters;
            AovSelection& aovs = choices[i].second;
            if (aovs.has(Aov::light_groups)) aovs.light_groups = light_groups;
            const double begin = processor_seconds();
            render(bench, renderer, {320, 180, 16, 1, kSamplerSobolOwen, aovs}, counters);
            best[i] = std::min(best[i], processor_seconds() - begin);
        }
    json.key("aov_time_ratio").begin_object();
    for (std::size_t i = 0; i < choices.size(); ++i)
        json.field(choices[i].first, best[i] / best[0], 4);
    json.end_object();
}

// The cost of splitting Sobol samples into replicates: the mean squared error with the variance AOV
// relative to that without it.
void measure_replicates(JsonWriter& json, const BenchScene& bench, Renderer& renderer) {
    constexpr std::uint32_t width = 48, height = 32;
    RenderCounters counters;
    const FloatImage reference =
        render(bench, renderer, {width, height, 2048, 999, kSamplerSobolOwen}, counters).resolve();
    const auto error = [&](const Settings& settings) {
        return compare_images(render(bench, renderer, settings, counters).resolve(), reference).mse;
    };
    json.key("replicates_mse_ratio").begin_object();
    for (const std::uint32_t samples : {16u, 64u, 256u}) {
        double with = 0, without = 0;
        for (std::uint32_t seed = 1; seed <= 4; ++seed) {
            Settings settings{width, height, samples, seed, kSamplerSobolOwen};
            without += error(settings);
            settings.aovs.aovs = {Aov::variance};
            with += error(settings);
        }
        json.field(std::to_string(samples), with / without, 4);
    }
    json.end_object();
}

Result<void> measure_scene(JsonWriter& json, const std::string& argument, bool errors, bool aovs) {
    BenchScene bench;
    HM_TRY(load(bench, argument));
    LightGroups groups = find_light_groups(bench.scene, bench.flat);
    bench.flat.aovs.source_groups = groups.source_groups;
    CpuRenderer renderer(bench.flat, 0);
    json.begin_object();
    json.field("scene", argument.substr(argument.find_last_of('/', argument.find(':')) + 1));
    json.field("triangles", renderer.bvh_stats().triangles);
    json.field("bvh_seconds", renderer.bvh_stats().build_seconds, 3);
    json.field("instruction_set", cpu_instruction_set());
    measure_rates(json, bench, renderer);
    if (errors) measure_errors(json, bench, renderer);
    if (aovs) measure_aovs(json, bench, renderer, groups.names);
    if (aovs) measure_replicates(json, bench, renderer);
    json.end_object();
    return {};
}

}  // namespace
}  // namespace hm

int main(int argc, char** argv) {
    bool errors = false, aovs = false;
    std::vector<std::string> scenes;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--errors") == 0)
            errors = true;
        else if (std::strcmp(argv[i], "--aovs") == 0)
            aovs = true;
        else
            scenes.emplace_back(argv[i]);
    }
    hm::JsonWriter json;
    hm::write_machine(json.begin_object());
    json.key("size").begin_array(hm::JsonLayout::compact).value(640).value(360).end_array();
    json.field("samples", 16).field("bounces", 8).key("scenes").begin_array();
    for (const std::string& scene : scenes) {
        const hm::Result<void> measured = hm::measure_scene(json, scene, errors, aovs);
        if (!measured) {
            fmt::print(stderr, "render_bench: {}\n", measured.error().line());
            return int(measured.error().kind);
        }
    }
    json.end_array().end_object();
    fmt::print("{}\n", json.text());
    return 0;
}
