// Writes large GLB files for load_bench: a wavy surface of many triangles, many nodes that show one
// small mesh, or one node that draws it many times (EXT_mesh_gpu_instancing).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

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

// "min" and "max", which positions must have.
std::string limits_of(const std::vector<float>& positions) {
    std::array<float, 3> low{positions[0], positions[1], positions[2]}, high = low;
    for (std::size_t i = 3; i < positions.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], positions[i]);
        high[i % 3] = std::max(high[i % 3], positions[i]);
    }
    return fmt::format(R"(,"min":[{},{},{}],"max":[{},{},{}])", low[0], low[1], low[2], high[0],
                       high[1], high[2]);
}

// Places on a square lattice.
std::vector<float> make_places(std::uint32_t count) {
    const auto side = std::uint32_t(std::ceil(std::sqrt(double(count))));
    std::vector<float> places;
    for (std::uint32_t i = 0; i < count; ++i)
        places.insert(places.end(), {3 * float(i % side), 0, 3 * float(i / side)});
    return places;
}

struct Writer {
    std::string binary, views, accessors;
    std::size_t count = 0;

    template <class T>
    void add(const std::vector<T>& values, std::string_view type, std::size_t width, int component,
             const std::string& rest = "") {
        const std::string_view comma = count == 0 ? "" : ",";
        const std::size_t bytes = values.size() * sizeof(T);
        views += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})", comma,
                             binary.size(), bytes);
        accessors +=
            fmt::format(R"({}{{"bufferView":{},"componentType":{},"type":"{}","count":{}{}}})",
                        comma, count, component, type, values.size() / width, rest);
        binary.append(reinterpret_cast<const char*>(values.data()), bytes);
        ++count;
    }

    bool write(const std::string& path, std::string nodes, const std::string& roots) {
        std::string json = fmt::format(
            R"({{"asset":{{"version":"2.0"}},"extensionsUsed":["EXT_mesh_gpu_instancing"],)"
            R"("buffers":[{{"byteLength":{}}}],"bufferViews":[{}],"accessors":[{}],)"
            R"("meshes":[{{"primitives":[{{"indices":3,"attributes":)"
            R"({{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}}}}]}}],)"
            R"("nodes":[{}],"scenes":[{{"nodes":[{}]}}],"scene":0}})",
            binary.size(), views, accessors, nodes, roots);
        json.resize((json.size() + 3) / 4 * 4, ' ');
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
};

}  // namespace

int main(int count, char** arguments) {
    const std::string_view kind = count == 4 ? arguments[1] : "";
    std::uint32_t n = 0;
    const std::string_view number = count == 4 ? arguments[2] : "";
    std::from_chars(number.data(), number.data() + number.size(), n);
    if (n == 0 || (kind != "triangles" && kind != "nodes" && kind != "instances")) {
        fmt::print(stderr, "usage: make_large_gltf triangles|nodes|instances COUNT OUT.glb\n");
        return 2;
    }
    const bool big = kind == "triangles";
    const Surface s = make_surface(big ? std::uint32_t(std::sqrt(n / 2.0)) : 16);
    Writer writer;
    writer.add(s.positions, "VEC3", 3, 5126, limits_of(s.positions));
    writer.add(s.normals, "VEC3", 3, 5126);
    writer.add(s.uvs, "VEC2", 2, 5126);
    writer.add(s.indices, "SCALAR", 1, 5125);
    std::string nodes = R"({"mesh":0})", roots = "0";
    if (!big) {
        const std::vector<float> places = make_places(n);
        if (kind == "instances") {
            writer.add(places, "VEC3", 3, 5126);
            nodes = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":)"
                    R"({"TRANSLATION":4}}}})";
        }
        for (std::uint32_t i = 0; kind == "nodes" && i < n; ++i) {
            if (i == 0) nodes = roots = "";
            nodes += fmt::format(R"({}{{"mesh":0,"name":"node {}","translation":[{},0,{}]}})",
                                 i == 0 ? "" : ",", i, places[3 * i], places[3 * i + 2]);
            roots += fmt::format("{}{}", i == 0 ? "" : ",", i);
        }
    }
    if (writer.write(arguments[3], nodes, roots)) return 0;
    fmt::print(stderr, "{}: can't be written\n", arguments[3]);
    return 6;
}
