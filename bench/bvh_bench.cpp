// Measures the CPU's acceleration structure on a generated scene: build time, and single-threaded
// tracing of coherent camera rays, diffuse bounces and shadow rays for each instruction set.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>
#include <vector>

#include "base/json_writer.h"
#include "base/machine.h"
#include "bvh/bvh.h"
#include "bvh/trace_batch.h"

namespace {

using namespace hm;

// A linear congruential generator; the renderer has its own samplers.
struct Random {
    std::uint64_t state;
    float next() {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return float(state >> 40) * 0x1p-24f;
    }
};

struct Surface {
    std::vector<Vertex> vertices;
    std::vector<uvec3> triangles;
};

// A grid of nu x nv quads over [0, 1]^2, mapped to positions by `place`.
template <class Place>
Surface make_grid(std::uint32_t nu, std::uint32_t nv, Place place) {
    Surface s;
    for (std::uint32_t j = 0; j <= nv; ++j)
        for (std::uint32_t i = 0; i <= nu; ++i) {
            Vertex vertex{};
            vertex.position = place(float(i) / float(nu), float(j) / float(nv));
            s.vertices.push_back(vertex);
        }
    for (std::uint32_t j = 0; j < nv; ++j)
        for (std::uint32_t i = 0; i < nu; ++i) {
            const std::uint32_t a = j * (nu + 1) + i;
            const std::uint32_t b = a + nu + 1;
            s.triangles.push_back({a, a + 1, b + 1});
            s.triangles.push_back({a, b + 1, b});
        }
    return s;
}

float terrain_height(float x, float z) {
    return 1.2f * std::sin(0.35f * x) * std::cos(0.3f * z) + 0.3f * std::sin(1.7f * x + 0.8f * z) +
           0.08f * std::sin(5.1f * x) * std::sin(4.3f * z);
}

Surface make_terrain() {
    return make_grid(300, 300, [](float u, float v) {
        const float x = 40 * (u - 0.5f);
        const float z = 40 * (v - 0.5f);
        return vec3(x, terrain_height(x, z), z);
    });
}

Surface make_sphere(Random& random) {
    const float x = 36 * (random.next() - 0.5f);
    const float z = 36 * (random.next() - 0.5f);
    const float radius = 0.4f + 1.2f * random.next();
    const float phase = 6 * random.next();
    const vec3 centre(x, terrain_height(x, z) + radius * (0.6f + 1.5f * random.next()), z);
    return make_grid(64, 42, [=](float u, float v) {
        const float phi = 6.2831853f * u;
        const float theta = 3.1415927f * v;
        const vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                     std::sin(theta) * std::sin(phi));
        const float bump =
            0.12f * std::sin(7 * n.x + phase) * std::sin(9 * n.y) * std::sin(8 * n.z + phase);
        return centre + radius * (1 + bump) * n;
    });
}

std::vector<Ray> camera_rays(std::uint32_t width, std::uint32_t height) {
    std::vector<Ray> rays;
    const vec3 origin(-17, 6, -17);
    const vec3 forward = normalize(vec3(1, -0.32f, 1));
    const vec3 right = normalize(cross(forward, vec3(0, 1, 0)));
    const vec3 up = cross(right, forward);
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const float sx = (2 * (float(x) + 0.5f) / float(width) - 1) * 0.8f;
            const float sy = (1 - 2 * (float(y) + 0.5f) / float(height)) * 0.6f;
            rays.push_back({origin, forward + sx * right + sy * up, INFINITY});
        }
    return rays;
}

struct Scene {
    std::vector<Surface> surfaces;
    std::vector<BvhMesh> meshes;
    std::vector<BvhInstance> instances;
    std::uint64_t triangles = 0;
};

Scene make_scene() {
    Scene scene;
    Random random{7};
    scene.surfaces.push_back(make_terrain());
    for (int i = 0; i < 60; ++i)
        scene.surfaces.push_back(make_sphere(random));
    for (const Surface& s : scene.surfaces) {
        scene.triangles += s.triangles.size();
        scene.meshes.push_back({{{s.vertices, s.triangles, true}}});
        const auto identity = mat4x3(1);
        scene.instances.push_back({std::uint32_t(scene.meshes.size() - 1), identity, identity});
    }
    return scene;
}

// Rays from the camera rays' hits in cosine-distributed directions, in pixel order.
std::vector<Ray> diffuse_rays(const Scene& scene, const std::vector<Ray>& rays,
                              const std::vector<Hit>& hits,
                              const std::vector<std::uint8_t>& found) {
    std::vector<Ray> result;
    Random random{11};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!found[i]) continue;
        const Surface& s = scene.surfaces[hits[i].instance];
        const uvec3 t = s.triangles[hits[i].primitive];
        const vec3 a = s.vertices[t.x].position;
        vec3 n = normalize(cross(s.vertices[t.y].position - a, s.vertices[t.z].position - a));
        if (dot(n, rays[i].direction) > 0) n = -n;
        const float z = 2 * random.next() - 1;
        const float phi = 6.2831853f * random.next();
        const float r = std::sqrt(1 - z * z);
        const vec3 on_sphere(r * std::cos(phi), r * std::sin(phi), z);
        const vec3 p = rays[i].origin + hits[i].t * rays[i].direction;
        result.push_back({p + 1e-3f * n, normalize(n + 0.999f * on_sphere), INFINITY});
    }
    return result;
}

std::vector<Ray> shuffled(std::vector<Ray> rays) {
    Random random{13};
    for (std::size_t i = rays.size(); i > 1; --i)
        std::swap(rays[i - 1], rays[std::size_t(random.next() * float(i))]);
    return rays;
}

// CPU time of this thread: less sensitive to other processes than wall-clock time.
double thread_seconds() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Traces the rays in blocks of a few milliseconds, several times, and sums the fastest time of each
// block, which excludes interrupted ones.
double mrays_per_second(void (*trace)(TraceBatch&), const BvhView& view,
                        const std::vector<Ray>& rays, std::vector<Hit>& hits,
                        std::vector<std::uint8_t>& found) {
    constexpr std::size_t kBlock = 8192;
    constexpr int kRepeats = 7;
    hits.resize(rays.size());
    found.resize(rays.size());
    std::vector<double> fastest((rays.size() + kBlock - 1) / kBlock,
                                std::numeric_limits<double>::infinity());
    for (int repeat = 0; repeat < kRepeats; ++repeat)
        for (std::size_t b = 0; b < fastest.size(); ++b) {
            const std::size_t first = b * kBlock;
            TraceBatch batch{&view,
                             rays.data() + first,
                             hits.data() + first,
                             found.data() + first,
                             std::min(kBlock, rays.size() - first),
                             kAcceptAll,
                             0};
            const double start = thread_seconds();
            trace(batch);
            fastest[b] = std::min(fastest[b], thread_seconds() - start);
        }
    double seconds = 0;
    for (const double s : fastest)
        seconds += s;
    return double(rays.size()) / seconds * 1e-6;
}

// Millions of rays per second of each kind, with one build of the traversal code.
void write_rates(JsonWriter& json, const TraceVariant& variant, const Scene& scene,
                 const BvhView& view, const std::vector<Ray>& camera) {
    std::vector<Hit> hits;
    std::vector<std::uint8_t> found;
    const auto measure = [&](const char* name, void (*trace)(TraceBatch&),
                             const std::vector<Ray>& rays) {
        json.field(name, mrays_per_second(trace, view, rays, hits, found), 4);
    };
    json.key(variant.name).begin_object(JsonLayout::compact);
    measure("closest_primary", variant.closest, camera);
    const std::vector<Ray> diffuse = diffuse_rays(scene, camera, hits, found);
    const std::vector<Ray> scattered = shuffled(diffuse);
    measure("closest_diffuse", variant.closest, diffuse);
    measure("closest_shuffled", variant.closest, scattered);
    measure("any_primary", variant.any, camera);
    measure("any_diffuse", variant.any, diffuse);
    measure("any_shuffled", variant.any, scattered);
    json.end_object();
}

}  // namespace

int main() {
    const Scene scene = make_scene();
    Bvh bvh = build_bvh(scene.meshes, scene.instances);
    for (int repeat = 0; repeat < 3; ++repeat) {
        Bvh again = build_bvh(scene.meshes, scene.instances);
        if (again.stats.build_seconds < bvh.stats.build_seconds) bvh = std::move(again);
    }
    JsonWriter json;
    write_machine(json.begin_object());
    json.field("triangles", bvh.stats.triangles).field("nodes", bvh.stats.nodes);
    json.field("packets", bvh.stats.packets).field("bytes", bvh.stats.bytes);
    json.field("build_mtris_per_s", double(bvh.stats.triangles) / bvh.stats.build_seconds * 1e-6,
               4);
    json.key("mrays_per_s").begin_object();
    const std::vector<Ray> camera = camera_rays(960, 720);
    for (const TraceVariant& variant : trace_variants())
        write_rates(json, variant, scene, bvh.view(), camera);
    json.end_object().end_object();
    fmt::print("{}\n", json.text());
}
