// Small glTF files for tests: a valid document whose top-level properties can be replaced.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/load.h"

namespace hm::gltf_test {

// Replaces or adds top-level properties of the base document; an empty value removes one.
using Overrides = std::map<std::string, std::string>;

// A triangle with all attributes, in one buffer stored as a data URI:
//   accessor/view  0 POSITION  1 NORMAL  2 TEXCOORD_0  3 indices  4 COLOR_0 (u8)  5 TANGENT
// The node shows mesh 0 with POSITION, NORMAL, TEXCOORD_0 and indices.
std::string document(const Overrides& overrides = {});
// The bytes of that buffer.
std::string triangle_bytes();
inline constexpr std::size_t kTriangleBytes = 164;

// A buffers property holding these bytes as a data URI.
std::string buffers(std::string_view bytes);

std::string base64(std::string_view bytes);
std::string glb(std::string json, std::string binary);

// A 1x1 PNG, RGBA 10 20 30 40, and a 2x1 PNG.
inline constexpr std::string_view kPng1 =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nGPgEpHTAAAAzQBlapmEQgAAAABJRU5ErkJggg"
    "==";
inline constexpr std::string_view kPng2 =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR4nGNgZGJmYWVj5wAAAIEAJZh10J8AAAAASUVORK"
    "5CYII=";

// The values as little-endian bytes.
template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// A temporary folder, removed by the destructor.
class Folder {
  public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();
    std::filesystem::path write(const std::string& name, std::string_view content) const;

  private:
    std::filesystem::path path_;
};

struct Loaded {
    Result<Scene> scene;
    Diagnostics diagnostics;

    // The number of warnings with this pointer whose message contains `text`.
    std::size_t warned(std::string_view pointer, std::string_view text) const;
};

Loaded load_text(std::string_view content);

// A file that must be rejected, and the expected error.
struct Refused {
    const char* what;
    Overrides overrides;
    const char* pointer;
    const char* message;  // substring
    ErrorKind kind = ErrorKind::invalid;
};
void expect_refused(const std::vector<Refused>& cases);

}  // namespace hm::gltf_test
