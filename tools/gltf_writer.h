// Writes a glTF 2.0 binary (.glb): geometry that meshes can share, materials, PNG textures, nodes,
// KHR_lights_punctual lights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "base/result.h"
#include "picture.h"
#include "shapes.h"

namespace hm {

// Textures are indices; -1 is none.
struct GltfMaterial {
    glm::vec4 color{1};
    float metallic = 1;
    std::optional<float> roughness = {};  // not written if absent; the format's default is 1
    int color_texture = -1, roughness_texture = -1, normal_texture = -1;
    float normal_scale = 1;
    bool two_sided = false;
    std::string_view alpha_mode = "OPAQUE";
    glm::vec3 emissive{0};
    float emissive_strength = 1;
};

struct GltfPrimitive {
    int geometry = -1;
    int material = -1;
};

struct GltfNode {
    std::string name;
    glm::vec3 translation{0};
    glm::quat rotation{1, 0, 0, 0};
    glm::vec3 scale{1};
    int mesh = -1;
    int camera = -1;
    int light = -1;
};

class GltfWriter {
  public:
    // Writes a triangle mesh's accessors. Texture coordinates and tangents are omitted if
    // `material` does not use them; indices have 16 bits if they fit. Other primitives may share
    // the geometry if their materials use the same attributes.
    GltfPrimitive add_primitive(const TriangleMesh& mesh, int material);

    Result<int> add_texture(const std::string& name, const Picture& picture);

    int add_material(const std::string& name, const GltfMaterial& material);

    int add_mesh(const std::string& name, std::span<const GltfPrimitive> primitives);
    int add_camera(const std::string& name, float yfov, float aspect_ratio, float z_near);
    int add_directional_light(const std::string& name, glm::vec3 color, float intensity);
    void add_node(const GltfNode& node);

    // One geometry and one material on one node: the common case.
    void add_object(const std::string& name, const TriangleMesh& mesh, int material);

    Result<void> write(const std::filesystem::path& path) const;

  private:
    struct MaterialNeeds {
        bool uvs = false;
        bool tangents = false;
    };
    struct Bounds {
        glm::vec3 low, high;
    };
    struct Geometry {
        std::string attributes;  // JSON object
        std::size_t indices = 0;
    };

    std::size_t add_view(std::span<const std::byte> bytes, int target);
    std::size_t add_accessor(std::span<const std::byte> bytes, int target, int component_type,
                             std::size_t count, const char* type,
                             const std::optional<Bounds>& bounds = {});
    std::string document() const;

    std::vector<std::byte> buffer_;
    std::vector<Geometry> geometries_;
    std::vector<MaterialNeeds> needs_;  // one per material
    // Each item is a JSON object.
    std::vector<std::string> views_, accessors_, images_, textures_, materials_, meshes_, cameras_,
        lights_, nodes_;
    std::set<std::string> extensions_;
};

// Looks from `eye` at `target`, as a camera's or a light's node rotation (-z forwards, +y up).
glm::quat look_rotation(glm::vec3 eye, glm::vec3 target);

}  // namespace hm
