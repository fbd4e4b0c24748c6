// Converts a Scene into the tables that shading reads. Geometry is not copied: the tables point
// into the scene, which must outlive them.
#pragma once

#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "scene/environment.h"
#include "scene/image_view.h"
#include "scene/scene.h"

namespace hm {

struct GeometryView {
    const Vertex* vertices;
    const VertexExtra* extras;  // null unless kGeometryHasExtras is set
    const uvec3* triangles;
    std::uint32_t vertex_count;
    std::uint32_t triangle_count;
};

struct Bounds {
    vec3 low{1e30f};
    vec3 high{-1e30f};
    bool empty() const { return low.x > high.x; }
    vec3 center() const { return (low + high) * 0.5f; }
    float radius() const { return empty() ? 0.0f : 0.5f * length(high - low); }
};

// Tables used only by AOVs (shading/path/aovs.h); empty if none are rendered.
struct AovTables {
    std::vector<std::uint32_t> source_groups;       // see scene/light_groups
    std::vector<mat4x3> next_transforms;            // per instance, see scene/motion
    std::vector<std::vector<vec3>> next_positions;  // of geometries; empty: unchanged
};

// The scene node that an instance comes from.
struct InstanceOrigin {
    std::uint32_t node;
    std::uint32_t copy;  // index into the node's `instances`; 0 if there are none
};

// The tables of shading/tables.inl that are filled from a scene.
struct SceneTables {
#define HM_SCENE_TABLE(number, Type, name) std::vector<Type> name;
#include "shading/tables.inl"
};

struct FlatScene : SceneTables {
    EnvironmentData environment{};
    float mean_radiance = 0;                         // of the environment, see EnvironmentMap
    std::vector<ImageView> images;                   // 0: white; then Scene::images
    std::vector<GeometryView> geometry_views;        // parallel to `geometries`
    std::vector<std::uint32_t> mesh_first_geometry;  // one more entry than meshes
    std::vector<InstanceOrigin> instance_origins;    // parallel to `instances`
    std::vector<std::uint32_t> light_nodes;          // parallel to `lights`
    AovTables aovs;
    Bounds bounds;  // world space
    // Flux into the scene, used to divide samples between light types. 0: no light of that type.
    double environment_power = 0;
    double punctual_power = 0;
    double emitter_power = 0;
};

// Which of the scene's light sources are used.
struct LightChoice {
    bool punctual = true;
    float punctual_scale = 1;  // of their intensities
    bool emitters = true;      // false: emission is still visible, but not sampled (no NEE)
};

// Upper limit on the power of a single light (luminance times area), so that sums stay finite.
inline constexpr float kMaxLightPower = 1e30f;

// Primitives with a normal map need tangents (scene/tangents prepares them).
// Warns about degenerate (zero) scales: such instances are not rendered; cameras and lights lose
// their direction.
FlatScene flatten(const Scene& scene, EnvironmentMap environment, LightChoice choice,
                  Diagnostics& diagnostics);

// Moves the environment out of a scene that is no longer rendered, to reuse it for the next one.
EnvironmentMap take_environment(FlatScene& scene);

}  // namespace hm
