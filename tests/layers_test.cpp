// Checks the includes between the folders of src/ against the layers in docs/architecture.md.
// CMake's links have the same layers, but includes of header-only folders compile without a link.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

const std::map<std::string, Names> kMayInclude = {
    {"base", {}},
    {"shading", {"base"}},
    {"image", {"base"}},
    {"scene", {"base", "shading", "image"}},
    {"gltf", {"base", "shading", "image", "scene"}},
    {"bvh", {"base", "shading"}},
    {"compare", {"base", "image"}},
    {"film", {"base", "shading", "image"}},
    {"denoise", {"base", "image", "compare", "shading"}},  // the last two: its tests
    {"output", {"base", "shading", "image", "film"}},
    {"cpu", {"base", "shading", "image", "scene", "bvh", "film"}},
    {"rhi", {"base"}},
    {"graph", {"base", "rhi"}},
    {"gpu", {"base", "shading", "image", "scene", "film", "rhi", "graph"}},
    {"session",
     {"base", "shading", "image", "scene", "gltf", "film", "denoise", "output", "cpu", "rhi",
      "gpu"}},
    {"library",
     {"base", "shading", "image", "scene", "gltf", "film", "denoise", "output", "session"}},
    {"app",
     {"base", "shading", "image", "scene", "gltf", "bvh", "compare", "film", "denoise", "output",
      "cpu", "rhi", "gpu", "session"}},
};

// Outside libraries that one room alone knows, by the first part of the include's path.
const std::map<std::string, std::string> kOnlyIn = {
    {"simdjson.h", "base"},
    {"spng.h", "image"},
    {"wuffs-unsupported-snapshot.c", "image"},
    {"jpeglib.h", "image"},
    {"OpenEXR", "image"},
    {"Imath", "image"},
    {"CLI", "app"},
    {"vulkan", "rhi"},
    {"volk.h", "rhi"},
    {"vk_mem_alloc.h", "rhi"},
};

fs::path source_dir() {
    const char* dir = std::getenv("HIMALAYA_SOURCE_DIR");
    return dir != nullptr ? fs::path(dir) : fs::current_path();
}

std::string first_part(const std::string& path) {
    return path.substr(0, path.find('/'));
}

// Every rule that a source file breaks, as "file:line: what".
std::vector<std::string> broken_rules(const std::string& name, const std::string& room,
                                      std::istream& text) {
    static const std::regex kInclude(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<std::string> broken;
    std::string line;
    for (int number = 1; std::getline(text, line); ++number) {
        std::smatch match;
        if (!std::regex_search(line, match, kInclude)) continue;
        const std::string included = match[1];
        const std::string part = first_part(included);
        const bool is_room = kMayInclude.contains(part) && included != part;
        const bool forbidden_room = is_room && part != room && !kMayInclude.at(room).contains(part);
        const auto only = kOnlyIn.find(part);
        const bool forbidden_library = only != kOnlyIn.end() && only->second != room;
        if (forbidden_room || forbidden_library || included.starts_with("..")) {
            broken.push_back(name + ":" + std::to_string(number) + ": " + room +
                             " may not include " + included);
        }
    }
    return broken;
}

TEST(Layers, EveryIncludeGoesDownwards) {
    const fs::path src = source_dir() / "src";
    ASSERT_TRUE(fs::is_directory(src)) << src;
    const Names kSources = {".h",    ".cpp",   ".inl",   ".comp", ".glsl",
                            ".rgen", ".rchit", ".rmiss", ".rahit"};
    int files = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
        if (!entry.is_regular_file() || !kSources.contains(entry.path().extension().string()))
            continue;
        const std::string name = fs::relative(entry.path(), src).generic_string();
        const std::string room = first_part(name);
        ASSERT_TRUE(kMayInclude.contains(room))
            << room << " is a new room: say what it may include";
        std::ifstream text(entry.path());
        for (const std::string& broken : broken_rules(name, room, text))
            ADD_FAILURE() << broken;
        ++files;
    }
    EXPECT_GT(files, 10);
}

// What callers of the library must have: a C++ compiler.
TEST(Layers, InstalledHeadersIncludeTheStandardLibraryOnly) {
    static const std::regex kAllowed(R"re(#include <(himalaya/\w+\.h|\w+)>)re");
    int includes = 0;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(source_dir() / "include/himalaya")) {
        std::ifstream text(entry.path());
        for (std::string line; std::getline(text, line);) {
            if (!line.starts_with("#include")) continue;
            EXPECT_TRUE(std::regex_match(line, kAllowed)) << entry.path() << ": " << line;
            ++includes;
        }
    }
    EXPECT_GT(includes, 10);
}

// Flags and exit codes belong to the program: below it messages name settings.
TEST(Layers, NothingBelowTheProgramNamesFlags) {
    static const std::regex kFlag(R"re("[^"]*--[a-z][^"]*")re");
    const fs::path src = source_dir() / "src";
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(src)) {
        const std::string name = fs::relative(entry.path(), src).generic_string();
        const bool is_code = name.ends_with(".cpp") || name.ends_with(".h");
        if (!is_code || first_part(name) == "app" || name.ends_with("_test.cpp")) continue;
        std::ifstream text(entry.path());
        std::string line;
        for (int number = 1; std::getline(text, line); ++number) {
            const bool of_others = line.find("gltf-transform") != line.npos;
            EXPECT_FALSE(!of_others && std::regex_search(line, kFlag))
                << name << ":" << number << ": " << line;
            EXPECT_EQ(line.find("ExitCode"), line.npos) << name << ":" << number << ": " << line;
        }
    }
}

TEST(Layers, TheCheckSeesWhatItShould) {
    const auto count = [](const std::string& room, const std::string& line) {
        std::istringstream text(line);
        return broken_rules("x.h", room, text).size();
    };
    EXPECT_EQ(count("shading", "#include \"scene/scene.h\""), 1u);
    EXPECT_EQ(count("cpu", "#  include <simdjson.h>"), 1u);
    EXPECT_EQ(count("bvh", "#include \"../scene/scene.h\""), 1u);
    EXPECT_EQ(count("gltf", "#include <simdjson.h>"), 1u);
    EXPECT_EQ(count("gltf", "#include \"scene/scene.h\""), 0u);
    EXPECT_EQ(count("base", "#include <simdjson.h>"), 0u);
    EXPECT_EQ(count("base", "#include <vector>"), 0u);
}

}  // namespace
