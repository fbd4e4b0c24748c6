// Scene -> the tables that shading reads. Geometry is not copied: the tables point into the scene,
// which must outlive them.
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
    const VertexExtra* extras;  // null without kGeometryHasExtras
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

// Tables for AOVs only (shading/path/aovs.h); empty without them.
struct AovTables {
    std::vector<std::uint32_t> source_groups;       // see scene/light_groups
    std::vector<mat4x3> next_transforms;            // of instances, see scene/motion
    std::vector<std::vector<vec3>> next_positions;  // of geometries; empty: as they are now
};

// Which of the scene's nodes an instance stands for.
struct InstanceOrigin {
    std::uint32_t node;
    std::uint32_t copy;  // of the node's `instances`; 0 without
};

// The tables of shading/tables.inl that a scene fills.
struct SceneTables {
#define HM_SCENE_TABLE(number, Type, name) std::vector<Type> name;
#include "shading/tables.inl"
};

struct FlatScene : SceneTables {
    EnvironmentData environment{};
    float mean_radiance = 0;                         // of the environment, see EnvironmentMap
    std::vector<ImageView> images;                   // 0: white; then Scene::images
    std::vector<GeometryView> geometry_views;        // parallel to `geometries`
    std::vector<std::uint32_t> mesh_first_geometry;  // one more than meshes
    std::vector<InstanceOrigin> instance_origins;    // parallel to `instances`
    std::vector<std::uint32_t> light_nodes;          // parallel to `lights`
    AovTables aovs;
    Bounds bounds;  // world space
    // Flux into the scene, for sharing samples between kinds of light. 0: none of that kind.
    double environment_power = 0;
    double punctual_power = 0;
    double emitter_power = 0;
};

// What of the scene's light is used.
struct LightChoice {
    bool punctual = true;
    bool emitters = true;  // off: emission is still seen, but never sampled as a light
};

// No single light counts as brighter than this (luminance times area): sums stay finite.
inline constexpr float kMaxLightPower = 1e30f;

// Primitives with a normal map need tangents (scene/tangents prepares them).
// Warns about what is scaled to nothing: instances are not drawn, cameras and lamps lose their aim.
FlatScene flatten(const Scene& scene, EnvironmentMap environment, LightChoice choice,
                  Diagnostics& diagnostics);

// Moves the environment out of a scene that is no longer rendered, to flatten the next one with it.
EnvironmentMap take_environment(FlatScene& scene);

}  // namespace hm
