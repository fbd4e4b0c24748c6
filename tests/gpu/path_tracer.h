// The stages of shading/path with brute-force hooks as a C++ struct, and the scene that the GPU
// tests draw with it. Both languages read the same tables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/world_triangle.h"
#include "scene/flatten.h"
#include "shading/shading.h"
#include "shading/tables/tables.h"

namespace hm::test {

struct PathTracer {
    // In the order of path_tables.glsl.
    RenderParams params{};
    CameraData camera{};
    EnvironmentData environment{};
    uint world_triangle_count = 0;
    std::vector<uint> sobol_directions;
    std::vector<uvec4> sobol_nibbles;
    std::vector<uint> blue_noise;
    std::vector<vec2> albedo_table;
    std::vector<vec2> albedo_average;
    std::vector<float> filter_table;
    std::vector<MaterialData> materials;
    std::vector<TextureUse> texture_uses;
    std::vector<GeometryData> geometries;
    std::vector<InstanceData> instances;
    std::vector<LightData> lights;
    std::vector<AliasEntry> light_alias;
    std::vector<EmitterTriangle> emitters;
    std::vector<AliasEntry> emitter_alias;
    std::vector<vec4> environment_texels;
    std::vector<AliasEntry> environment_alias;
    std::vector<Vertex> scene_vertices;
    std::vector<VertexExtra> scene_extras;
    std::vector<uvec3> scene_triangles;
    std::vector<uvec2> scene_offsets;
    std::vector<uvec3> scene_images;
    std::vector<vec4> scene_texels;
    std::vector<WorldTriangle> world_triangles;

#include "gpu/brute_force.h"

    // Copies the scene's tables. `params` is the caller's to fill, camera and light ranges too.
    explicit PathTracer(const FlatScene& scene);

    void choose_lights(const FlatScene& scene) {
        set_light_ranges(scene, params);
    }

    // The storage behind bindings 2 and up. The settings are copied into `settings`, which must
    // outlive the use of the result.
    struct Settings {
        RenderParams params;
        CameraData camera;
        EnvironmentData environment;
        uint world_triangle_count;
    };
    std::vector<std::span<std::byte>> buffers(Settings& settings);

  private:
    void add_geometry(const GeometryView& view);
    void add_world_triangles(const FlatScene& scene, uint instance);
    void add_image(const ImageView& image);
};

// A small box with every feature that the stages have: textures of both filters and all wrap modes,
// normal maps, masked and blended surfaces, vertex colours, a second UV set, a mirrored instance,
// emissive and textured emissive triangles, the three punctual lights and an environment.
struct TestScene {
    Scene scene;
    FlatScene flat;
    CameraData camera{};

    TestScene();

    // Sobol with Owen scrambling, six bounces, MIS, energy compensation, a Gaussian filter; light
    // ranges for that; no picture size.
    RenderParams params() const;
};

}  // namespace hm::test
