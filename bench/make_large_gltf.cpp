// Writes large GLB files for load_bench: a wavy surface of many triangles, many nodes with the same
// small mesh, or one node with many instances of it (EXT_mesh_gpu_instancing).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/json_writer.h"

namespace hm {
namespace {

// The accessors, in the order in which they are added.
constexpr int kPositions = 0, kNormals = 1, kUvs = 2, kIndices = 3, kTranslations = 4;

struct Surface {
    std::vector<float> positions, normals, uvs;
    std::vector<std::uint32_t> indices;
};

// n x n quads over [-1, 1]^2.
Surface make_surface(std::uint32_t n) {
    Surface s;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const float u = float(i) / float(n), v = float(j) / float(n);
            const float x = 2 * u - 1, z = 2 * v - 1;
            s.positions.insert(s.positions.end(), {x, 0.1f * std::sin(9 * x) * std::cos(7 * z), z});
            s.normals.insert(s.normals.end(), {0, 1, 0});
            s.uvs.insert(s.uvs.end(), {u, v});
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, b = a + n + 1;
            s.indices.insert(s.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return s;
}

// "min" and "max", which glTF requires for positions.
void write_limits(JsonWriter& json, const std::vector<float>& positions) {
    std::array<float, 3> low{positions[0], positions[1], positions[2]}, high = low;
    for (std::size_t i = 3; i < positions.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], positions[i]);
        high[i % 3] = std::max(high[i % 3], positions[i]);
    }
    json.key("min").values(low).key("max").values(high);
}

// Positions on a square lattice.
std::vector<float> make_positions(std::uint32_t count) {
    const auto side = std::uint32_t(std::ceil(std::sqrt(double(count))));
    std::vector<float> positions;
    for (std::uint32_t i = 0; i < count; ++i)
        positions.insert(positions.end(), {3 * float(i % side), 0, 3 * float(i / side)});
    return positions;
}

// The binary chunk, and the arrays of the document that describe it.
class Buffer {
  public:
    Buffer() {
        views_.begin_array(JsonLayout::compact);
        accessors_.begin_array(JsonLayout::compact);
    }

    template <class T>
    void add(const std::vector<T>& values, std::string_view type, std::size_t width, int component,
             bool limits = false) {
        const std::size_t bytes = values.size() * sizeof(T);
        views_.begin_object().field("buffer", 0).field("byteOffset", binary_.size());
        views_.field("byteLength", bytes).end_object();
        accessors_.begin_object().field("bufferView", count_++).field("componentType", component);
        accessors_.field("type", type).field("count", values.size() / width);
        if constexpr (std::is_same_v<T, float>)
            if (limits) write_limits(accessors_, values);
        accessors_.end_object();
        binary_.append(reinterpret_cast<const char*>(values.data()), bytes);
    }

    void write_members(JsonWriter& json) {
        json.key("buffers").begin_array().begin_object().field("byteLength", binary_.size());
        json.end_object().end_array();
        json.key("bufferViews").raw(views_.end_array().text());
        json.key("accessors").raw(accessors_.end_array().text());
    }

    const std::string& binary() const { return binary_; }

  private:
    std::string binary_;
    JsonWriter views_, accessors_;
    std::size_t count_ = 0;
};

void write_instances(JsonWriter& json) {
    json.begin_object().field("mesh", 0).key("extensions").begin_object();
    json.key("EXT_mesh_gpu_instancing").begin_object().key("attributes").begin_object();
    json.field("TRANSLATION", kTranslations).end_object().end_object().end_object().end_object();
}

// One node with the mesh at each position.
void write_nodes(JsonWriter& json, const std::vector<float>& positions) {
    for (std::size_t i = 0; 3 * i < positions.size(); ++i) {
        json.begin_object().field("mesh", 0).field("name", fmt::format("node {}", i));
        json.key("translation").values(std::span(positions).subspan(3 * i, 3)).end_object();
    }
}

std::string document(std::string_view kind, Buffer& buffer, const std::vector<float>& positions) {
    JsonWriter json;
    json.begin_object(JsonLayout::compact);
    json.key("asset").begin_object().field("version", "2.0").end_object();
    json.key("extensionsUsed").begin_array().value("EXT_mesh_gpu_instancing").end_array();
    buffer.write_members(json);
    json.key("meshes").begin_array().begin_object().key("primitives").begin_array();
    json.begin_object().field("indices", kIndices).key("attributes").begin_object();
    json.field("POSITION", kPositions).field("NORMAL", kNormals).field("TEXCOORD_0", kUvs);
    json.end_object().end_object().end_array().end_object().end_array();
    json.key("nodes").begin_array();
    if (kind == "triangles") json.begin_object().field("mesh", 0).end_object();
    if (kind == "instances") write_instances(json);
    if (kind == "nodes") write_nodes(json, positions);
    json.end_array().key("scenes").begin_array().begin_object().key("nodes").begin_array();
    for (std::size_t i = 0; i < (kind == "nodes" ? positions.size() / 3 : 1); ++i)
        json.value(i);
    json.end_array().end_object().end_array().field("scene", 0).end_object();
    std::string text = json.text();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    return text;
}

bool write_glb(const std::string& path, const std::string& json, const std::string& binary) {
    std::ofstream file(path, std::ios::binary);
    const auto word = [&](std::size_t value) {
        const auto little = std::uint32_t(value);
        file.write(reinterpret_cast<const char*>(&little), 4);
    };
    file.write("glTF", 4);
    word(2);
    word(12 + 8 + json.size() + 8 + binary.size());
    word(json.size());
    file.write("JSON", 4).write(json.data(), std::streamsize(json.size()));
    word(binary.size());
    file.write("BIN\0", 4).write(binary.data(), std::streamsize(binary.size()));
    return bool(file.flush());
}

}  // namespace
}  // namespace hm

int main(int count, char** arguments) {
    using namespace hm;
    const std::string_view kind = count == 4 ? arguments[1] : "";
    std::uint32_t n = 0;
    const std::string_view number = count == 4 ? arguments[2] : "";
    std::from_chars(number.data(), number.data() + number.size(), n);
    if (n == 0 || (kind != "triangles" && kind != "nodes" && kind != "instances")) {
        fmt::print(stderr, "usage: make_large_gltf triangles|nodes|instances COUNT OUT.glb\n");
        return 2;
    }
    const Surface s =
        make_surface(kind == "triangles" ? std::uint32_t(std::sqrt(double(n) / 2)) : 16);
    const std::vector<float> positions = make_positions(n);
    Buffer buffer;
    buffer.add(s.positions, "VEC3", 3, 5126, true);
    buffer.add(s.normals, "VEC3", 3, 5126);
    buffer.add(s.uvs, "VEC2", 2, 5126);
    buffer.add(s.indices, "SCALAR", 1, 5125);
    if (kind == "instances") buffer.add(positions, "VEC3", 3, 5126);
    if (write_glb(arguments[3], document(kind, buffer, positions), buffer.binary())) return 0;
    fmt::print(stderr, "{}: can't be written\n", arguments[3]);
    return 6;
}
