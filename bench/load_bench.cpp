// Measures loading glTF files beside what can't be avoided: reading their bytes and building the
// acceleration structure. Every file is measured in a process of its own, for its peak of memory.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "base/files.h"
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

// Peak of resident memory since the last reset, MiB.
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

int measure_file(const std::string& path) {
    const Times read = measure([&] { (void)read_file(path); });
    reset_peak();
    Diagnostics diagnostics;
    Result<Scene> scene;
    const Times load = measure([&] { scene = load_gltf(path, diagnostics); });
    if (!scene) {
        fmt::print(stderr, "{}\n", scene.error().line());
        return int(scene.error().code);
    }
    const double load_peak = peak_mib();
    reset_peak();
    Bvh bvh;
    const Times built = measure([&] { bvh = build(*scene); });
    const double build_peak = peak_mib();
    fmt::print(
        "    {{\"file\": \"{}\", \"triangles\": {}, \"read_s\": {:.4f}, \"load_s\": {:.4f}, "
        "\"bvh_s\": {:.4f}, \"load_cpu_s\": {:.4f}, \"bvh_cpu_s\": {:.4f}, "
        "\"load_peak_mib\": {:.1f}, \"bvh_peak_mib\": {:.1f}, \"time_ratio\": {:.3f}, "
        "\"memory_ratio\": {:.3f}}}",
        path.substr(path.rfind('/') + 1), bvh.stats.triangles, read.wall, load.wall, built.wall,
        load.processor, built.processor, load_peak, build_peak,
        (load.processor + built.processor) / (read.processor + built.processor),
        std::max(load_peak, build_peak) / build_peak);
    std::fflush(stdout);
    return 0;
}

}  // namespace

int main(int count, char** arguments) {
    fmt::print("{{{},\n  \"files\": [\n", machine_json());
    for (int i = 1; i < count; ++i) {
        std::fflush(stdout);
        const pid_t child = fork();
        if (child == 0) _exit(measure_file(arguments[i]));
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child || status != 0) return 1;
        fmt::print("{}\n", i + 1 < count ? "," : "");
    }
    fmt::print("  ]}}\n");
    return 0;
}
