// Textures, materials and meshes of the caller's own: checked, and copied into the scene.
#include <fmt/format.h>
#include <himalaya/scene.h>

#include <cmath>

#include "image/read.h"
#include "library/errors.h"
#include "library/scene_impl.h"

namespace himalaya {
namespace {

glm::vec3 to_glm(Vec3 v) {
    return {v.x, v.y, v.z};
}
glm::vec4 to_glm(Vec4 v) {
    return {v.x, v.y, v.z, v.w};
}

bool all_finite(std::span<const float> values) {
    for (const float value : values)
        if (!std::isfinite(value)) return false;
    return true;
}

template <class T>
std::span<const float> floats_of(std::span<const T> values) {
    return {reinterpret_cast<const float*>(values.data()), values.size() * (sizeof(T) / 4)};
}

// The library's choices are those of the shading code.
constexpr bool is(auto choice, std::uint32_t value) {
    return std::uint32_t(choice) == value;
}
static_assert(is(Wrap::repeat, hm::kWrapRepeat) && is(Wrap::clamp, hm::kWrapClamp) &&
              is(Wrap::mirror, hm::kWrapMirror));
static_assert(is(AlphaMode::opaque, hm::kAlphaOpaque) && is(AlphaMode::mask, hm::kAlphaMask) &&
              is(AlphaMode::blend, hm::kAlphaBlend));

hm::TextureSlot slot_of(const std::optional<TextureSlot>& slot, const hm::Scene& scene) {
    hm::TextureSlot result;
    if (!slot) return result;
    if (slot->texture >= scene.images.size())
        refuse(fmt::format("there is no texture {}", slot->texture));
    result.image = int(slot->texture);
    result.wrap_u = std::uint32_t(slot->wrap_u);
    result.wrap_v = std::uint32_t(slot->wrap_v);
    return result;
}

void check_unit(float value, const char* name) {
    if (!(value >= 0 && value <= 1)) refuse(fmt::format("{} must be within 0 and 1", name));
}

void check_mesh(const Mesh& mesh, const hm::Scene& scene) {
    const std::size_t count = mesh.positions.size();
    const auto check_length = [&](std::size_t length, const char* name) {
        if (length != 0 && length != count)
            refuse(fmt::format("the mesh has {} {} for {} positions", length, name, count));
    };
    check_length(mesh.normals.size(), "normals");
    check_length(mesh.uvs.size(), "uvs");
    check_length(mesh.colors.size(), "colors");
    if (!all_finite(floats_of(mesh.positions)) || !all_finite(floats_of(mesh.normals)) ||
        !all_finite(floats_of(mesh.uvs)) || !all_finite(floats_of(mesh.colors)))
        refuse("the mesh has a value that is not finite");
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            if (index >= count)
                refuse(fmt::format("a triangle has index {}, but there are {} positions", index,
                                   count));
    if (mesh.material && *mesh.material >= scene.materials.size())
        refuse(fmt::format("there is no material {}", *mesh.material));
}

hm::Primitive primitive_of(const Mesh& mesh) {
    hm::Primitive primitive;
    primitive.has_normals = !mesh.normals.empty();
    if (mesh.material) primitive.material = int(*mesh.material);
    primitive.vertices.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        hm::Vertex& vertex = primitive.vertices[i];
        vertex = {};
        vertex.position = to_glm(mesh.positions[i]);
        if (!mesh.normals.empty()) vertex.normal = to_glm(mesh.normals[i]);
        if (!mesh.uvs.empty()) vertex.uv0 = {mesh.uvs[i].x, mesh.uvs[i].y};
    }
    for (const Vec4& color : mesh.colors)
        primitive.extras.push_back({{0, 0}, to_glm(color)});
    primitive.triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        primitive.triangles.push_back({t[0], t[1], t[2]});
    return primitive;
}

}  // namespace

std::uint32_t Scene::add_texture(const Texture& texture) {
    return guarded([&] {
        if (texture.width == 0 || texture.height == 0 || texture.width > hm::kMaxImageSide ||
            texture.height > hm::kMaxImageSide)
            refuse(fmt::format("a texture of {} x {} pixels", texture.width, texture.height));
        const std::size_t bytes = std::size_t(texture.width) * texture.height * 4;
        if (texture.rgba.size() != bytes)
            refuse(
                fmt::format("the texture has {} bytes, expected {}", texture.rgba.size(), bytes));
        hm::Image8 image(texture.width, texture.height);
        for (std::size_t i = 0; i < bytes; ++i)
            image.pixels[i / 4][i % 4] = texture.rgba[i];
        impl_->scene.images.push_back(std::move(image));
        return std::uint32_t(impl_->scene.images.size() - 1);
    });
}

std::uint32_t Scene::add_material(const Material& material) {
    return guarded([&] {
        hm::Scene& scene = impl_->scene;
        for (const float x : {material.base_color.x, material.base_color.y, material.base_color.z,
                              material.base_color.w})
            check_unit(x, "base color");
        check_unit(material.metallic, "metallic");
        check_unit(material.roughness, "roughness");
        check_unit(material.specular, "specular");
        for (const float x : {material.emission.x, material.emission.y, material.emission.z})
            if (!(x >= 0 && std::isfinite(x))) refuse("emission must be finite and not negative");
        hm::Material added;
        added.name = material.name;
        added.base_color = to_glm(material.base_color);
        added.metallic = material.metallic;
        added.roughness = material.roughness;
        added.specular_weight = material.specular;
        added.emissive_factor = to_glm(material.emission);
        added.alpha_mode = std::uint32_t(material.alpha_mode);
        added.alpha_cutoff = material.alpha_cutoff;
        added.double_sided = material.double_sided;
        added.unlit = material.unlit;
        added.base_color_texture = slot_of(material.base_color_texture, scene);
        added.metallic_roughness_texture = slot_of(material.metallic_roughness_texture, scene);
        added.normal_texture = slot_of(material.normal_texture, scene);
        added.emissive_texture = slot_of(material.emission_texture, scene);
        scene.materials.push_back(std::move(added));
        return std::uint32_t(scene.materials.size() - 1);
    });
}

std::uint32_t Scene::add_mesh(const Mesh& mesh) {
    return guarded([&] {
        hm::Scene& scene = impl_->scene;
        check_mesh(mesh, scene);
        hm::Mesh added;
        added.name = mesh.name;
        added.primitives.push_back(primitive_of(mesh));
        scene.meshes.push_back(std::move(added));
        impl_->lacks_tangents = true;
        return std::uint32_t(scene.meshes.size() - 1);
    });
}

}  // namespace himalaya
