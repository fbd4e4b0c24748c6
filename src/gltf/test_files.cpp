#include "gltf/test_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace hm::gltf_test {
namespace {

const Overrides& base_properties() {
    static const Overrides properties{
        {"asset", R"({"version":"2.0"})"},
        {"buffers", buffers(triangle_bytes())},
        {"bufferViews", R"([
            {"buffer":0,"byteOffset":0,"byteLength":36},
            {"buffer":0,"byteOffset":36,"byteLength":36},
            {"buffer":0,"byteOffset":72,"byteLength":24},
            {"buffer":0,"byteOffset":96,"byteLength":6},
            {"buffer":0,"byteOffset":104,"byteLength":12},
            {"buffer":0,"byteOffset":116,"byteLength":48}])"},
        {"accessors", R"([
            {"bufferView":0,"componentType":5126,"type":"VEC3","count":3,
             "min":[0,0,0],"max":[1,2,0]},
            {"bufferView":1,"componentType":5126,"type":"VEC3","count":3},
            {"bufferView":2,"componentType":5126,"type":"VEC2","count":3},
            {"bufferView":3,"componentType":5123,"type":"SCALAR","count":3},
            {"bufferView":4,"componentType":5121,"type":"VEC4","count":3,"normalized":true},
            {"bufferView":5,"componentType":5126,"type":"VEC4","count":3}])"},
        {"meshes", R"([{"name":"triangle","primitives":[{"indices":3,
            "attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}}]}])"},
        {"nodes", R"([{"mesh":0}])"},
        {"scenes", R"([{"nodes":[0]}])"},
        {"scene", "0"},
    };
    return properties;
}

}  // namespace

std::string triangle_bytes() {
    const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 2, 0};
    const std::vector<float> normals{0, 0, 1, 0, 0, 2, 0, 3, 4};
    const std::vector<float> uvs{0, 0, 1, 0, 0, 1};
    const std::vector<std::uint16_t> indices{0, 1, 2, 0};  // one more as padding
    const std::vector<std::uint8_t> colors{255, 0, 51, 255, 0, 255, 0, 102, 0, 0, 255, 0};
    const std::vector<float> tangents{1, 0, 0, 1, 2, 0, 0, -1, 0, 1, 0, 1};
    return bytes_of(positions) + bytes_of(normals) + bytes_of(uvs) + bytes_of(indices) +
           bytes_of(colors) + bytes_of(tangents);
}

std::string document(const Overrides& overrides) {
    Overrides all = base_properties();
    for (const auto& [key, value] : overrides)
        all[key] = value;
    std::string text;
    for (const auto& [key, value] : all)
        if (!value.empty())
            text += fmt::format("{}\"{}\":{}", text.empty() ? "{" : ",", key, value);
    return text + "}";
}

std::string base64(std::string_view bytes) {
    static constexpr char kDigits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= n ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

std::string buffers(std::string_view bytes) {
    return fmt::format(R"([{{"byteLength":{},"uri":"data:application/octet-stream;base64,{}"}}])",
                       bytes.size(), base64(bytes));
}

std::string glb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) {
        return bytes_of(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
    };
    std::string out =
        "glTF" + word(2) + word(12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size()));
    out += word(json.size()) + "JSON" + json;
    if (!binary.empty()) out += word(binary.size()) + std::string("BIN\0", 4) + binary;
    return out;
}

Folder::Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "himalaya-gltf-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) ADD_FAILURE() << "no temporary folder";
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path Folder::write(const std::string& name, std::string_view content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    // Removed first: some file systems sync to disk when a file is overwritten.
    std::filesystem::remove(path_ / name);
    std::ofstream(path_ / name, std::ios::binary)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
    return path_ / name;
}

std::size_t Loaded::warned(std::string_view pointer, std::string_view text) const {
    std::size_t count = 0;
    for (const Warning& warning : diagnostics.warnings())
        if (warning.location == pointer && warning.message.find(text) != std::string::npos)
            count += warning.count;
    return count;
}

Loaded load_text(std::string_view content) {
    const Folder folder;
    Loaded out{fail(ErrorKind::internal, "", "", ""), {}};
    out.scene = load_gltf(folder.write("scene.gltf", content), out.diagnostics);
    return out;
}

void expect_refused(const std::vector<Refused>& cases) {
    for (const Refused& c : cases) {
        const Loaded loaded = load_text(document(c.overrides));
        ASSERT_FALSE(loaded.scene) << c.what;
        const Error& error = loaded.scene.error();
        EXPECT_EQ(error.kind, c.kind) << c.what << ": " << error.line();
        EXPECT_EQ(error.location, c.pointer) << c.what << ": " << error.line();
        EXPECT_NE(error.message.find(c.message), std::string::npos)
            << c.what << ": " << error.line();
    }
}

}  // namespace hm::gltf_test
