#include "gltf_writer.h"

#include <fmt/format.h>
#include <spng.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>

#include "base/files.h"

namespace hm {
namespace {

constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span<const T>(values));
}

// Not fmt::join, which GCC 12 warns about at -O3.
template <class Items>
std::string joined(const Items& items, const std::string& separator) {
    std::string text;
    for (const std::string& item : items) {
        if (!text.empty()) text += separator;
        text += item;
    }
    return text;
}

std::string json(glm::vec3 v) {
    return fmt::format("[{},{},{}]", v.x, v.y, v.z);
}

// Six digits: nodes are many, and a micrometre in a metre is enough for them.
std::string short_json(glm::vec3 v) {
    return fmt::format("[{:.6g},{:.6g},{:.6g}]", v.x, v.y, v.z);
}

Result<std::vector<std::byte>> encode_png(const std::string& name, const Picture& picture) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 spng_ctx_free);
    spng_ihdr header{};
    header.width = picture.width;
    header.height = picture.height;
    header.bit_depth = 8;
    header.color_type = std::uint8_t(picture.channels == 1   ? SPNG_COLOR_TYPE_GRAYSCALE
                                     : picture.channels == 3 ? SPNG_COLOR_TYPE_TRUECOLOR
                                                             : SPNG_COLOR_TYPE_TRUECOLOR_ALPHA);
    int error = context ? 0 : 1;
    if (!error) error = spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
    if (!error) error = spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 9);
    if (!error) error = spng_set_ihdr(context.get(), &header);
    if (!error)
        error = spng_encode_image(context.get(), picture.pixels.data(), picture.pixels.size(),
                                  SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    std::size_t size = 0;
    void* data = error ? nullptr : spng_get_png_buffer(context.get(), &size, &error);
    if (error) return fail(ErrorKind::internal, name, "", spng_strerror(error));
    std::vector<std::byte> bytes(size);
    std::memcpy(bytes.data(), data, size);
    std::free(data);
    return bytes;
}

void append_u32(std::vector<std::byte>& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(std::byte(value >> shift & 0xffu));
}

}  // namespace

std::size_t GltfWriter::add_view(std::span<const std::byte> bytes, int target) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    const std::string use = target ? fmt::format(",\"target\":{}", target) : "";
    views_.push_back(fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}{}}}",
                                 buffer_.size(), bytes.size(), use));
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return views_.size() - 1;
}

std::size_t GltfWriter::add_accessor(std::span<const std::byte> bytes, int target,
                                     int component_type, std::size_t count, const char* type,
                                     const std::string& bounds) {
    const std::size_t view = add_view(bytes, target);
    accessors_.push_back(
        fmt::format("{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}",
                    view, component_type, count, type, bounds));
    return accessors_.size() - 1;
}

GltfPrimitive GltfWriter::add_primitive(const TriangleMesh& mesh, int material) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const std::string bounds = fmt::format(",\"min\":{},\"max\":{}", json(low), json(high));
    const std::size_t count = mesh.positions.size();
    std::vector<std::string> attributes;
    const auto add = [&](const char* name, std::span<const std::byte> bytes, const char* type,
                         const std::string& range) {
        const std::size_t accessor = add_accessor(bytes, kArrayBuffer, kFloat, count, type, range);
        attributes.push_back(fmt::format("\"{}\":{}", name, accessor));
    };
    add("POSITION", bytes_of(mesh.positions), "VEC3", bounds);
    add("NORMAL", bytes_of(mesh.normals), "VEC3", "");
    const MaterialNeeds needs = needs_[std::size_t(material)];
    if (needs.tangents) add("TANGENT", bytes_of(mesh.tangents), "VEC4", "");
    if (needs.uvs) add("TEXCOORD_0", bytes_of(mesh.uvs), "VEC2", "");

    Geometry geometry;
    geometry.attributes = fmt::format("{{{}}}", joined(attributes, ","));
    const bool narrow = count <= 65535;
    const std::vector<std::uint16_t> shorts(mesh.indices.begin(), mesh.indices.end());
    geometry.indices =
        add_accessor(narrow ? bytes_of(shorts) : bytes_of(mesh.indices), kElementArrayBuffer,
                     narrow ? kUnsignedShort : kUnsignedInt, mesh.indices.size(), "SCALAR", "");
    geometries_.push_back(geometry);
    return {int(geometries_.size()) - 1, material};
}

Result<int> GltfWriter::add_texture(const std::string& name, const Picture& picture) {
    HM_TRY_ASSIGN(const std::vector<std::byte> png, encode_png(name, picture));
    const std::size_t view = add_view(png, 0);
    images_.push_back(fmt::format(
        "{{\"name\":\"{}\",\"mimeType\":\"image/png\",\"bufferView\":{}}}", name, view));
    textures_.push_back(fmt::format("{{\"sampler\":0,\"source\":{}}}", images_.size() - 1));
    return int(textures_.size()) - 1;
}

int GltfWriter::add_material(const std::string& name, const std::string& properties) {
    for (std::size_t at = properties.find("\"KHR_"); at != std::string::npos;
         at = properties.find("\"KHR_", at + 1))
        extensions_.insert(properties.substr(at + 1, properties.find('"', at + 1) - at - 1));
    needs_.push_back({properties.find("Texture\"") != std::string::npos,
                      properties.find("\"normalTexture\"") != std::string::npos});
    materials_.push_back(fmt::format("{{\"name\":\"{}\",{}}}", name, properties));
    return int(materials_.size()) - 1;
}

int GltfWriter::add_mesh(const std::string& name, std::span<const GltfPrimitive> primitives) {
    std::vector<std::string> parts;
    for (const GltfPrimitive& p : primitives) {
        const Geometry& geometry = geometries_[std::size_t(p.geometry)];
        parts.push_back(fmt::format("{{\"attributes\":{},\"indices\":{},\"material\":{}}}",
                                    geometry.attributes, geometry.indices, p.material));
    }
    meshes_.push_back(
        fmt::format("{{\"name\":\"{}\",\"primitives\":[{}]}}", name, joined(parts, ",")));
    return int(meshes_.size()) - 1;
}

int GltfWriter::add_camera(const std::string& name, float yfov, float aspect_ratio, float z_near) {
    cameras_.push_back(
        fmt::format("{{\"name\":\"{}\",\"type\":\"perspective\",\"perspective\":"
                    "{{\"yfov\":{},\"aspectRatio\":{},\"znear\":{}}}}}",
                    name, yfov, aspect_ratio, z_near));
    return int(cameras_.size()) - 1;
}

int GltfWriter::add_directional_light(const std::string& name, glm::vec3 color, float intensity) {
    extensions_.insert("KHR_lights_punctual");
    lights_.push_back(
        fmt::format("{{\"name\":\"{}\",\"type\":\"directional\",\"color\":{},\"intensity\":{}}}",
                    name, json(color), intensity));
    return int(lights_.size()) - 1;
}

void GltfWriter::add_node(const GltfNode& node) {
    std::string text = fmt::format("{{\"name\":\"{}\"", node.name);
    if (node.mesh >= 0) text += fmt::format(",\"mesh\":{}", node.mesh);
    if (node.camera >= 0) text += fmt::format(",\"camera\":{}", node.camera);
    if (node.light >= 0)
        text +=
            fmt::format(",\"extensions\":{{\"KHR_lights_punctual\":{{\"light\":{}}}}}", node.light);
    if (node.translation != glm::vec3(0))
        text += fmt::format(",\"translation\":{}", short_json(node.translation));
    if (node.rotation != glm::quat(1, 0, 0, 0)) {
        const glm::quat& q = node.rotation;
        text += fmt::format(",\"rotation\":[{:.6g},{:.6g},{:.6g},{:.6g}]", q.x, q.y, q.z, q.w);
    }
    if (node.scale != glm::vec3(1)) text += fmt::format(",\"scale\":{}", short_json(node.scale));
    nodes_.push_back(text + "}");
}

void GltfWriter::add_object(const std::string& name, const TriangleMesh& mesh, int material) {
    const GltfPrimitive primitive = add_primitive(mesh, material);
    add_node({.name = name, .mesh = add_mesh(name, {&primitive, 1})});
}

std::string GltfWriter::document() const {
    std::vector<std::string> parts;
    const auto add_array = [&](const char* name, const std::vector<std::string>& items) {
        if (!items.empty()) parts.push_back(fmt::format("\"{}\":[{}]", name, joined(items, ",\n")));
    };
    parts.push_back("\"asset\":{\"version\":\"2.0\",\"generator\":\"himalaya make_scenes\"}");
    if (!extensions_.empty())
        parts.push_back(fmt::format("\"extensionsUsed\":[\"{}\"]", joined(extensions_, "\",\"")));
    if (!lights_.empty())
        parts.push_back(
            fmt::format("\"extensions\":{{\"KHR_lights_punctual\":{{\"lights\":[{}]}}}}",
                        joined(lights_, ",")));
    std::vector<std::string> all;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        all.push_back(std::to_string(i));
    parts.push_back(fmt::format("\"scene\":0,\"scenes\":[{{\"nodes\":[{}]}}]", joined(all, ",")));
    add_array("nodes", nodes_);
    add_array("meshes", meshes_);
    add_array("cameras", cameras_);
    add_array("materials", materials_);
    if (!textures_.empty())
        parts.push_back("\"samplers\":[{\"magFilter\":9729,\"minFilter\":9987}]");
    add_array("textures", textures_);
    add_array("images", images_);
    add_array("accessors", accessors_);
    add_array("bufferViews", views_);
    parts.push_back(fmt::format("\"buffers\":[{{\"byteLength\":{}}}]", buffer_.size()));
    return fmt::format("{{{}}}", joined(parts, ",\n"));
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
