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
#include "scene/render_params.h"
#include "shading/shading.h"
#include "shading/tables/tables.h"

namespace hm::test {

struct PathTracer {
#define HM_FRAME_VALUE(Type, name) Type name{};
#define HM_TABLE(number, Type, name) std::vector<Type> name;
#include "shading/tables.inl"
    uint world_triangle_count = 0;
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

    // The storage of bindings 2 and up of path_tables.glsl. The settings are copied into
    // `settings`, which must outlive the result.
    struct Settings {
#define HM_FRAME_VALUE(Type, name) Type name;
#include "shading/tables.inl"
        uint world_triangle_count;
    };
    std::vector<std::span<std::byte>> buffers(Settings& settings);
    static constexpr std::uint32_t kBufferCount = 8
#define HM_TABLE(number, Type, name) +1
#include "shading/tables.inl"
        ;

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
