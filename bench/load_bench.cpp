// Measures loading glTF files, compared with the unavoidable cost: reading their bytes and building
// the acceleration structure. Each run is a separate process, to measure its peak memory; the
// median run of each file is printed.
#include <fmt/format.h>
#include <sys/wait.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json_writer.h"
#include "base/machine.h"
#include "bvh/bvh.h"
#include "gltf/load.h"
#include "scene/flatten.h"

namespace {

using namespace hm;

struct Times {
    double wall, processor;
};

template <class Work>
Times measure(const Work& work) {
    const double wall = wall_seconds(), processor = processor_seconds();
    work();
    return {wall_seconds() - wall, processor_seconds() - processor};
}

// Peak resident memory since the last reset, MiB.
double peak_mib() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::atof(line.c_str() + 6) / 1024;
    return 0;
}

void reset_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

Bvh build(const Scene& scene) {
    Diagnostics diagnostics;
    const FlatScene flat = flatten(scene, {}, {}, diagnostics);
    std::vector<BvhMesh> meshes;
    for (const Mesh& mesh : scene.meshes) {
        BvhMesh& out = meshes.emplace_back();
        for (const Primitive& p : mesh.primitives)
            out.geometries.push_back({p.vertices, p.triangles, true});
    }
    std::vector<BvhInstance> instances;
    for (const InstanceData& i : flat.instances)
        instances.push_back({i.mesh, i.object_to_world, i.world_to_object});
    return build_bvh(meshes, instances);
}

struct Measured {
    std::size_t triangles;
    double read_wall;
    Times load, build;
    double load_peak, build_peak;
    double time_ratio, memory_ratio;
};

// Measures in this process.
Result<Measured> measure_here(const std::string& path) {
    // Starts the thread pool before the clock: the build alone would need it too.
    tbb::parallel_for(0, 1000, [](int) {});
    const Times read = measure([&] { (void)read_file(path); });
    reset_peak();
    Measured m{};
    Diagnostics diagnostics;
    Result<Scene> scene;
    m.load = measure([&] { scene = load_gltf(path, diagnostics); });
    if (!scene) return tl::unexpected(std::move(scene.error()));
    m.load_peak = peak_mib();
    reset_peak();
    Bvh bvh;
    m.build = measure([&] { bvh = build(*scene); });
    m.build_peak = peak_mib();
    m.triangles = bvh.stats.triangles;
    m.read_wall = read.wall;
    m.time_ratio = (m.load.processor + m.build.processor) / (read.processor + m.build.processor);
    m.memory_ratio = std::max(m.load_peak, m.build_peak) / m.build_peak;
    return m;
}

// Measures in a child process; nullopt if it fails.
std::optional<Measured> measure_apart(const std::string& path) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return std::nullopt;
    const pid_t child = fork();
    if (child == 0) {
        const Result<Measured> measured = measure_here(path);
        if (!measured) fmt::print(stderr, "{}\n", measured.error().line());
        _exit(measured && write(ends[1], &*measured, sizeof *measured) == sizeof *measured ? 0 : 1);
    }
    close(ends[1]);
    Measured m{};
    const bool whole = child > 0 && read(ends[0], &m, sizeof m) == sizeof m;
    close(ends[0]);
    if (child > 0) waitpid(child, nullptr, 0);
    return whole ? std::optional(m) : std::nullopt;
}

// The run with the median time ratio: page faults are occasionally slow.
std::optional<Measured> median(const std::string& path) {
    constexpr std::size_t kRuns = 9;
    std::vector<Measured> runs;
    while (runs.size() < kRuns) {
        const auto run = measure_apart(path);
        if (!run) return std::nullopt;
        runs.push_back(*run);
    }
    std::sort(runs.begin(), runs.end(),
              [](const Measured& a, const Measured& b) { return a.time_ratio < b.time_ratio; });
    return runs[kRuns / 2];
}

void write(JsonWriter& json, const std::string& path, const Measured& m) {
    json.begin_object(JsonLayout::compact);
    json.field("file", path.substr(path.rfind('/') + 1)).field("triangles", m.triangles);
    json.field("read_s", m.read_wall, 4).field("load_s", m.load.wall, 4);
    json.field("bvh_s", m.build.wall, 4).field("load_cpu_s", m.load.processor, 4);
    json.field("bvh_cpu_s", m.build.processor, 4).field("load_peak_mib", m.load_peak, 5);
    json.field("bvh_peak_mib", m.build_peak, 5).field("time_ratio", m.time_ratio, 4);
    json.field("memory_ratio", m.memory_ratio, 4).end_object();
}

}  // namespace

int main(int count, char** arguments) {
    JsonWriter json;
    write_machine(json.begin_object());
    json.key("files").begin_array();
    for (int i = 1; i < count; ++i) {
        const auto measured = median(arguments[i]);
        if (!measured) return 1;
        write(json, arguments[i], *measured);
    }
    json.end_array().end_object();
    fmt::print("{}\n", json.text());
    return 0;
}
