// A scene: read from a glTF file, or built from the caller's arrays, which are copied.
#pragma once

#include <himalaya/export.h>
#include <himalaya/types.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace himalaya {

struct LoadSettings {
    std::string scene{};    // name or index; empty: the one that the file names
    std::string variant{};  // of materials
    // Bytes that loading may take. 0: three quarters of the machine's memory, 16 GiB at most.
    std::uint64_t memory_limit = 0;
    bool allow_external = false;  // read files outside of the scene file's folder
};

enum class Wrap { repeat, clamp, mirror };

// RGBA, 8 bits each, rows from the top. Base colour and emission are sRGB, other slots linear.
struct Texture {
    std::uint32_t width = 0, height = 0;
    std::span<const std::uint8_t> rgba{};  // width * height * 4
};

struct TextureSlot {
    std::uint32_t texture = 0;  // of Scene::add_texture
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

enum class AlphaMode { opaque, mask, blend };

// glTF's metallic-roughness material. Textures multiply the factors.
struct Material {
    std::string name{};
    Vec4 base_color{1, 1, 1, 1};
    float metallic = 0;
    float roughness = 1;
    float specular = 1;  // weight of a dielectric's reflection
    Vec3 emission{};     // radiance
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool double_sided = false;
    bool unlit = false;
    std::optional<TextureSlot> base_color_texture, metallic_roughness_texture, normal_texture,
        emission_texture;
};

// Optional arrays are empty or as long as `positions`.
struct Mesh {
    std::string name{};
    std::span<const Vec3> positions{};
    std::span<const Triangle> triangles{};
    std::span<const Vec3> normals{};  // unit length; without them triangles are shaded flat
    std::span<const Vec2> uvs{};
    std::span<const Vec4> colors{};           // multiply the base colour, linear
    std::optional<std::uint32_t> material{};  // of Scene::add_material; none: glTF's default
};

// Placed at the origin of its transform; spot and directional lights shine along -z.
struct Light {
    enum class Kind { point, spot, directional };
    std::string name{};
    Kind kind = Kind::point;
    Vec3 color{1, 1, 1};
    float intensity = 1;                               // W/sr; directional: W/m^2
    float range = 0;                                   // metres; 0: no limit
    float inner_cone = 0, outer_cone = 0.7853981634f;  // radians from the axis
};

// Looks along -z of its transform, with y up.
struct Camera {
    std::string name{};
    float vertical_fov = 45;                // degrees
    std::optional<float> half_height = {};  // metres: orthographic instead
};

class HIMALAYA_API Scene {
  public:
    Scene();  // empty
    static Scene load(const std::filesystem::path& gltf, const LoadSettings& settings = {});

    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;
    ~Scene();

    // What was added is referred to by the returned index. Arrays are checked and copied.
    std::uint32_t add_texture(const Texture& texture);
    std::uint32_t add_material(const Material& material);
    std::uint32_t add_mesh(const Mesh& mesh);
    void add_instance(std::uint32_t mesh, const Matrix& transform = kIdentity,
                      const std::string& name = {});
    void add_light(const Light& light, const Matrix& transform = kIdentity);
    void add_camera(const Camera& camera, const Matrix& transform = kIdentity);

    // What was tolerated in the file.
    const std::vector<std::string>& warnings() const;

    struct Impl;
    Impl& impl() { return *impl_; }  // for the library's own use

  private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace himalaya
