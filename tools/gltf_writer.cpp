#include "gltf_writer.h"

#include <array>
#include <cmath>
#include <limits>

#include "base/files.h"
#include "base/json_writer.h"

namespace hm {
namespace {

constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr const char* kEmissiveStrength = "KHR_materials_emissive_strength";
constexpr const char* kLightsPunctual = "KHR_lights_punctual";

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span<const T>(values));
}

// A JSON object on one line, with the members that `write` adds.
template <class Write>
std::string object_text(const Write& write) {
    JsonWriter json;
    json.begin_object(JsonLayout::compact);
    write(json);
    return json.end_object().text();
}

void write_vector(JsonWriter& json, std::string_view key, std::span<const float> vector) {
    json.key(key).values(vector);
}

// Six digits keep the file small; a micrometre per metre is precise enough for nodes.
void write_rounded(JsonWriter& json, std::string_view key, std::span<const float> vector) {
    json.key(key).begin_array();
    for (const float x : vector)
        json.value(double(x), 6);
    json.end_array();
}

template <class Vector>
std::span<const float> components(const Vector& v) {
    return {&v[0], std::size_t(v.length())};
}

void write_texture(JsonWriter& json, std::string_view key, int texture) {
    if (texture >= 0) json.key(key).begin_object().field("index", texture).end_object();
}

// Omits properties that have their default values, except factors.
void write_material(JsonWriter& json, const GltfMaterial& m) {
    json.key("pbrMetallicRoughness").begin_object();
    write_vector(json, "baseColorFactor", components(m.color));
    json.field("metallicFactor", m.metallic);
    if (m.roughness) json.field("roughnessFactor", *m.roughness);
    write_texture(json, "baseColorTexture", m.color_texture);
    write_texture(json, "metallicRoughnessTexture", m.roughness_texture);
    json.end_object();
    if (m.normal_texture >= 0) {
        json.key("normalTexture").begin_object().field("index", m.normal_texture);
        json.field("scale", m.normal_scale).end_object();
    }
    if (m.two_sided) json.field("doubleSided", true);
    if (m.alpha_mode != "OPAQUE") json.field("alphaMode", m.alpha_mode);
    if (m.alpha_mode == "MASK") json.field("alphaCutoff", 0.5f);
    if (m.emissive != glm::vec3(0)) write_vector(json, "emissiveFactor", components(m.emissive));
    if (m.emissive_strength != 1) {
        json.key("extensions").begin_object().key(kEmissiveStrength).begin_object();
        json.field("emissiveStrength", m.emissive_strength).end_object().end_object();
    }
}

void append_u32(std::vector<std::byte>& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(std::byte(value >> shift & 0xffu));
}

}  // namespace

std::size_t GltfWriter::add_view(std::span<const std::byte> bytes, int target) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    views_.push_back(object_text([&](JsonWriter& json) {
        json.field("buffer", 0).field("byteOffset", buffer_.size());
        json.field("byteLength", bytes.size());
        if (target != 0) json.field("target", target);
    }));
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return views_.size() - 1;
}

std::size_t GltfWriter::add_accessor(std::span<const std::byte> bytes, int target,
                                     int component_type, std::size_t count, const char* type,
                                     const std::optional<Bounds>& bounds) {
    const std::size_t view = add_view(bytes, target);
    accessors_.push_back(object_text([&](JsonWriter& json) {
        json.field("bufferView", view).field("componentType", component_type);
        json.field("count", count).field("type", type);
        if (!bounds) return;
        write_vector(json, "min", components(bounds->low));
        write_vector(json, "max", components(bounds->high));
    }));
    return accessors_.size() - 1;
}

GltfPrimitive GltfWriter::add_primitive(const TriangleMesh& mesh, int material) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const std::size_t count = mesh.positions.size();
    const auto add = [&](std::span<const std::byte> bytes, const char* type,
                         const std::optional<Bounds>& bounds = {}) {
        return add_accessor(bytes, kArrayBuffer, kFloat, count, type, bounds);
    };
    const MaterialNeeds needs = needs_[std::size_t(material)];
    Geometry geometry;
    geometry.attributes = object_text([&](JsonWriter& json) {
        json.field("POSITION", add(bytes_of(mesh.positions), "VEC3", Bounds{low, high}));
        json.field("NORMAL", add(bytes_of(mesh.normals), "VEC3"));
        if (needs.tangents) json.field("TANGENT", add(bytes_of(mesh.tangents), "VEC4"));
        if (needs.uvs) json.field("TEXCOORD_0", add(bytes_of(mesh.uvs), "VEC2"));
    });
    const bool narrow = count <= 65535;
    const std::vector<std::uint16_t> shorts(mesh.indices.begin(), mesh.indices.end());
    geometry.indices =
        add_accessor(narrow ? bytes_of(shorts) : bytes_of(mesh.indices), kElementArrayBuffer,
                     narrow ? kUnsignedShort : kUnsignedInt, mesh.indices.size(), "SCALAR");
    geometries_.push_back(geometry);
    return {int(geometries_.size()) - 1, material};
}

Result<int> GltfWriter::add_texture(const std::string& name, const Picture& picture) {
    HM_TRY_ASSIGN(const std::vector<std::byte> png, encode_png(name, picture));
    const std::size_t view = add_view(png, 0);
    images_.push_back(object_text([&](JsonWriter& json) {
        json.field("name", name).field("mimeType", "image/png").field("bufferView", view);
    }));
    textures_.push_back(object_text(
        [&](JsonWriter& json) { json.field("sampler", 0).field("source", images_.size() - 1); }));
    return int(textures_.size()) - 1;
}

int GltfWriter::add_material(const std::string& name, const GltfMaterial& material) {
    if (material.emissive_strength != 1) extensions_.insert(kEmissiveStrength);
    const bool normals = material.normal_texture >= 0;
    needs_.push_back(
        {normals || material.color_texture >= 0 || material.roughness_texture >= 0, normals});
    materials_.push_back(object_text([&](JsonWriter& json) {
        json.field("name", name);
        write_material(json, material);
    }));
    return int(materials_.size()) - 1;
}

int GltfWriter::add_mesh(const std::string& name, std::span<const GltfPrimitive> primitives) {
    meshes_.push_back(object_text([&](JsonWriter& json) {
        json.field("name", name).key("primitives").begin_array();
        for (const GltfPrimitive& p : primitives) {
            const Geometry& geometry = geometries_[std::size_t(p.geometry)];
            json.begin_object().key("attributes").raw(geometry.attributes);
            json.field("indices", geometry.indices).field("material", p.material).end_object();
        }
        json.end_array();
    }));
    return int(meshes_.size()) - 1;
}

int GltfWriter::add_camera(const std::string& name, float yfov, float aspect_ratio, float z_near) {
    cameras_.push_back(object_text([&](JsonWriter& json) {
        json.field("name", name).field("type", "perspective").key("perspective").begin_object();
        json.field("yfov", yfov).field("aspectRatio", aspect_ratio).field("znear", z_near);
        json.end_object();
    }));
    return int(cameras_.size()) - 1;
}

int GltfWriter::add_directional_light(const std::string& name, glm::vec3 color, float intensity) {
    extensions_.insert(kLightsPunctual);
    lights_.push_back(object_text([&](JsonWriter& json) {
        json.field("name", name).field("type", "directional");
        write_vector(json, "color", components(color));
        json.field("intensity", intensity);
    }));
    return int(lights_.size()) - 1;
}

void GltfWriter::add_node(const GltfNode& node) {
    nodes_.push_back(object_text([&](JsonWriter& json) {
        json.field("name", node.name);
        if (node.mesh >= 0) json.field("mesh", node.mesh);
        if (node.camera >= 0) json.field("camera", node.camera);
        if (node.light >= 0) {
            json.key("extensions").begin_object().key(kLightsPunctual).begin_object();
            json.field("light", node.light).end_object().end_object();
        }
        if (node.translation != glm::vec3(0))
            write_rounded(json, "translation", components(node.translation));
        const glm::quat& q = node.rotation;
        if (q != glm::quat(1, 0, 0, 0))
            write_rounded(json, "rotation", std::array{q.x, q.y, q.z, q.w});
        if (node.scale != glm::vec3(1)) write_rounded(json, "scale", components(node.scale));
    }));
}

void GltfWriter::add_object(const std::string& name, const TriangleMesh& mesh, int material) {
    const GltfPrimitive primitive = add_primitive(mesh, material);
    add_node({.name = name, .mesh = add_mesh(name, {&primitive, 1})});
}

std::string GltfWriter::document() const {
    JsonWriter json;
    const auto add_array = [&](const char* name, const std::vector<std::string>& items,
                               JsonLayout layout = JsonLayout::lines) {
        if (items.empty()) return;
        json.key(name).begin_array(layout);
        for (const std::string& item : items)
            json.raw(item);
        json.end_array();
    };
    json.begin_object(JsonLayout::lines).key("asset").begin_object().field("version", "2.0");
    json.field("generator", "himalaya make_scenes").end_object();
    if (!extensions_.empty()) json.key("extensionsUsed").values(extensions_);
    if (!lights_.empty()) {
        json.key("extensions").begin_object().key(kLightsPunctual).begin_object();
        add_array("lights", lights_, JsonLayout::compact);
        json.end_object().end_object();
    }
    json.field("scene", 0).key("scenes").begin_array().begin_object().key("nodes").begin_array();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        json.value(i);
    json.end_array().end_object().end_array();
    add_array("nodes", nodes_);
    add_array("meshes", meshes_);
    add_array("cameras", cameras_);
    add_array("materials", materials_);
    if (!textures_.empty()) {
        json.key("samplers").begin_array().begin_object().field("magFilter", 9729);
        json.field("minFilter", 9987).end_object().end_array();
    }
    add_array("textures", textures_);
    add_array("images", images_);
    add_array("accessors", accessors_);
    add_array("bufferViews", views_);
    json.key("buffers").begin_array().begin_object().field("byteLength", buffer_.size());
    return json.end_object().end_array().end_object().text();
}

Result<void> GltfWriter::write(const std::filesystem::path& path) const {
    std::string text = document();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t binary_size = (buffer_.size() + 3) / 4 * 4;
    std::vector<std::byte> file;
    append_u32(file, 0x46546c67u);  // "glTF"
    append_u32(file, 2);
    append_u32(file, std::uint32_t(12 + 8 + text.size() + 8 + binary_size));
    append_u32(file, std::uint32_t(text.size()));
    append_u32(file, 0x4e4f534au);  // "JSON"
    const auto text_bytes = std::as_bytes(std::span<const char>(text));
    file.insert(file.end(), text_bytes.begin(), text_bytes.end());
    append_u32(file, std::uint32_t(binary_size));
    append_u32(file, 0x004e4942u);  // "BIN"
    file.insert(file.end(), buffer_.begin(), buffer_.end());
    file.resize((file.size() + 3) / 4 * 4);
    return write_file_atomically(path, file);
}

glm::quat look_rotation(glm::vec3 eye, glm::vec3 target) {
    const glm::vec3 back = glm::normalize(eye - target);
    const glm::vec3 up = std::abs(back.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
    const glm::vec3 right = glm::normalize(glm::cross(up, back));
    return glm::normalize(glm::quat_cast(glm::mat3(right, glm::cross(back, right), back)));
}

}  // namespace hm
