// A scene as described by a glTF file, validated and decoded, before scene/flatten converts it into
// the tables that the renderer reads.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "scene/animation.h"
#include "scene/deformation.h"
#include "scene/transform.h"
#include "shading/structs.h"

namespace hm {

inline constexpr int kUnset = -1;

// The end of a parameter's range that has none.
inline constexpr float kNoLimit = std::numeric_limits<float>::max();

// The texture of one material slot. Images are shared between slots by index.
struct TextureSlot {
    int image = kUnset;  // into Scene::images
    std::uint32_t wrap_u = kWrapRepeat;
    std::uint32_t wrap_v = kWrapRepeat;
    std::uint32_t filter_mode = kFilterLinear;
    std::uint32_t uv_set = 0;
    vec3 uv_row_u{1, 0, 0};  // KHR_texture_transform as a 2x3 matrix
    vec3 uv_row_v{0, 1, 0};
};

struct Material {
    std::string name;
    // base_color, metallic, ..., base_color_texture, ...: generated from the list.
#define HM_FACTOR(owner, key, type, member, start, low, high, below, animated, table, meaning) \
    type member = type(start);
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning) TextureSlot slot{};
#include "shading/material/parameters.inl"
    float specular_weight = 1;  // not set by any file
    std::uint32_t alpha_mode = kAlphaOpaque;
    bool double_sided = false;
    bool unlit = false;
    bool specular_glossiness = false;  // see kMaterialGlossy

    vec3 emissive() const {
        return emissive_factor * emissive_strength;
    }
};

// Triangles with one material. Flat shaded without normals; `tangent` is read only if has_tangents
// is set; `extras` is empty or as long as `vertices` (uv1 is zero and colour one where absent).
struct Primitive {
    std::vector<Vertex> vertices;
    std::vector<VertexExtra> extras;
    std::vector<uvec3> triangles;
    int material = kUnset;  // kUnset: glTF's default material
    bool has_normals = false;
    bool has_tangents = false;
    // If set, scene/pose computes `vertices` and `extras` from it.
    std::shared_ptr<const Deformation> deformation;
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<float> weights{};  // one per morph target; all primitives have the same number
};

// `joints` are node indices, in the order of the meshes' joint indices; `inverse_bind` transforms
// from mesh space to the space of the joint in which the vertex is at rest.
struct Skin {
    std::string name;
    std::vector<int> joints;
    std::vector<glm::mat4> inverse_bind;  // one per joint
};

struct Camera {
    std::string name;
    bool perspective = true;
    float yfov = 0.8f;             // radians
    float aspect_ratio = 0;        // 0: that of the image
    float xmag = 1, ymag = 1;      // orthographic half extents, metres
    std::optional<Error> fault{};  // the value in the file that makes it unusable
};

struct Light {
    std::string name;
    std::uint32_t kind = kLightPoint;
    vec3 color{1, 1, 1};
    float intensity = 1;
    float range = 0;  // 0: no limit
    float inner_cone = 0;
    float outer_cone = 0.7853981634f;
};

// Parents precede their children, so one pass over the array computes world transforms.
struct Node {
    std::string name;
    int index = kUnset;  // node index in the file, for messages
    int parent = kUnset;
    glm::dmat4 local{1};
    std::optional<Transform> rest;  // `local` when no animation moves the node
    int mesh = kUnset;
    int camera = kUnset;
    int light = kUnset;
    // Instance transforms of the mesh, relative to the node; empty: one instance, at the node's
    // transform.
    std::vector<glm::mat4> instances{};
    bool visible = true;  // false hides meshes and lights of the node and its descendants
    // With a skin, the mesh's vertices are in world space, relative to Scene::origin, and the
    // node's transform does not affect them. Such a mesh is used only by this node, or by nodes
    // that give it the same pose.
    int skin = kUnset;
    bool skin_mirrors = false;   // set by posing: the joints reverse the triangles' winding
    std::vector<float> weights;  // morph target weights; empty: those of the mesh
};

struct Scene {
    std::string file;       // for messages
    std::string generator;  // asset.generator, empty if absent
    std::string hash;       // of the file and all files that it references (base/hash.h)
    // What is rendered has world coordinates relative to this point of the file's world space.
    // Skinned vertices are relative to it too, so scene/origin sets it before posing.
    glm::dvec3 origin{0};
    bool double_precision = false;  // transforms are combined in it, else in floats
    std::vector<Node> nodes;        // only those of the selected glTF scene
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<TextureImage> images;
    std::vector<Camera> cameras;
    std::vector<Light> lights;
    std::vector<Skin> skins;
    std::vector<Animation> animations;
};

// JSON pointer to the node in its file; empty if the node is not from a file.
std::string pointer_of(const Node& node);

// Whether each node and all its ancestors are visible.
std::vector<bool> visible_nodes(const Scene& scene);

// A transform within another one, in the precision that the scene needs.
glm::dmat4 combine(const Scene& scene, const glm::dmat4& outer, const glm::dmat4& inner);

// World transform of each node, relative to Scene::origin.
std::vector<glm::dmat4> world_transforms(const Scene& scene);

}  // namespace hm
