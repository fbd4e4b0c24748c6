// `himalaya info`: its output for a shipped scene, JSON that fits docs/info.schema.json, hostile
// names, and the exit codes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "app/cli/info.h"
#include "app/cli/info_report.h"
#include "base/json_document.h"
#include "cli/info_schema.h"
#include "scene/material_parameters.h"
#include "support/asset_files.h"

namespace {

using namespace hm;
using namespace hm::cli;
using namespace hm::test;
namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

// A temporary glTF file.
class Info : public ::testing::Test {
  protected:
    Info() : path_(fs::temp_directory_path() / ("info_test-" + std::to_string(::getpid()))) {}
    ~Info() override {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }

    static InfoOptions options(const std::string& input, const fs::path& path, bool json) {
        InfoOptions o;
        o.input = input;
        o.scene_file = path;
        o.json = json;
        return o;
    }

    InfoOptions write(const std::string& text, bool json = false) const {
        std::ofstream(path_, std::ios::binary) << text;
        return options("the file", path_, json);
    }

    struct Printed {
        int code;
        std::string text;
    };
    static Printed run(const InfoOptions& what) {
        ::testing::internal::CaptureStdout();
        const Result<ExitCode> code = info(what);
        return {code ? int(*code) : int(exit_code(code.error().kind)),
                ::testing::internal::GetCapturedStdout()};
    }

    fs::path path_;
};

// Names of a terminal's escape sequences: colours, the title, a second line, a C1 introducer.
constexpr const char* kHostile = R"({"asset":{"version":"2.0","generator":"\u001b[31mred\u0007"},
    "extensionsUsed":["EXT_\u001b]0;title\u0007","KHR_materials_variants"],
    "extensions":{"KHR_materials_variants":{"variants":[{"name":"a\u009bb"}]}},
    "scenes":[{"name":"one\ntwo","nodes":[0]}],
    "nodes":[{"name":"\u001b[2J","camera":0}],
    "cameras":[{"name":"\u0000\u007f","type":"perspective","perspective":{"yfov":1,"znear":1}}],
    "materials":[{"name":"\r\u001b[1A"}]})";

void expect_printable(const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool is_c1 =
            byte == 0xC2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0;
        EXPECT_FALSE((byte < 0x20 && byte != '\n') || byte == 0x7F || is_c1) << "byte " << i;
    }
}

TEST_F(Info, TextOfTheCornellBox) {
    const Printed printed =
        run(options("demo:cornell", source_folder() / "scenes/cornell.glb", false));
    EXPECT_EQ(printed.code, 0);
    EXPECT_EQ(printed.text, read_text(source_folder() / "tests/cli/info_cornell.txt"));
}

TEST_F(Info, JsonFitsTheSchema) {
    for (const char* scene : {"cornell", "spheres", "hero"}) {
        SCOPED_TRACE(scene);
        const fs::path path = source_folder() / "scenes" / (std::string(scene) + ".glb");
        const Printed printed = run(options(scene, path, true));
        EXPECT_EQ(printed.code, 0);
        expect_fits_schema(printed.text);
    }
    const Printed hostile = run(write(kHostile, true));
    EXPECT_EQ(hostile.code, 0);
    expect_fits_schema(hostile.text);
}

TEST_F(Info, MaterialsHaveEveryParameter) {
    const std::string file = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
        "materials":[{"pbrMetallicRoughness":{"roughnessFactor":0.25},"alphaCutoff":0.75,
                      "emissiveFactor":[1,0.5,0],"extensions":{"KHR_materials_ior":{"ior":1.75}}}],
        "extensionsUsed":["KHR_materials_ior"],
        "accessors":[{"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}]})";
    const auto document = JsonDocument::parse(run(write(file, true)).text, "report").value();
    const Json material = document.root().at("/scene/materials/0").value();
    for (const MaterialFactor& factor : material_factors())
        EXPECT_EQ(material.has(factor.name), !factor.extended || factor.name == "ior")
            << factor.name;
    EXPECT_EQ(material.number("ior").value(), 1.75f);
    EXPECT_EQ(material.number("roughness").value(), 0.25f);
    EXPECT_EQ(material.number_list("emissive_factor").value(), (std::vector<float>{1, 0.5f, 0}));
    const std::string text = run(write(file)).text;
    EXPECT_NE(text.find("0: OPAQUE, base color 1 1 1 1, metallic 1, roughness 0.25, "
                        "emissive factor 1 0.5 0, alpha cutoff 0.75, ior 1.75\n"),
              std::string::npos)
        << text;
}

TEST_F(Info, HostileNamesAreMadePrintable) {
    for (const bool json : {false, true}) {
        const Printed printed = run(write(kHostile, json));
        expect_printable(printed.text);
        for (const char* part : {"x1B[31mred", "x1B]0;title", "x1B[2J", "x1B[1A", "one", "xC2"})
            EXPECT_NE(printed.text.find(part), std::string::npos) << part << "\n" << printed.text;
        EXPECT_EQ(printed.text.find("one\ntwo"), std::string::npos);
    }
}

TEST_F(Info, ExitCodes) {
    EXPECT_EQ(
        run(write(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{}]})")).code, 0);
    const Printed noted = run(write(R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_a"],
        "scenes":[{"nodes":[0]}],"nodes":[{}]})"));
    EXPECT_EQ(noted.code, 0);
    EXPECT_NE(noted.text.find("Notes (1)\n  /extensionsUsed/0: "), std::string::npos) << noted.text;
    const Printed warned = run(write(R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_a"],
        "scenes":[{"nodes":[0]}],"nodes":[{"extensions":{"EXT_a":{}}}]})"));
    EXPECT_EQ(warned.code, 10);
    EXPECT_NE(warned.text.find("EXT_a, used: ignored"), std::string::npos) << warned.text;
    EXPECT_NE(warned.text.find("Warnings (1)\n  /extensionsUsed/0: "), std::string::npos)
        << warned.text;
    const std::string refused =
        R"({"asset":{"version":"2.0"},"extensionsUsed":["EXT_a"],"extensionsRequired":["EXT_a"]})";
    EXPECT_EQ(run(write(refused)).code, int(ExitCode::unsupported));
    EXPECT_NE(run(write(refused)).text.find("EXT_a, required: refused"), std::string::npos);
    EXPECT_EQ(run(write("hello")).code, int(ExitCode::invalid));
    EXPECT_EQ(run(options("gone", path_ / "gone.glb", false)).code, int(ExitCode::unreadable));
}

TEST_F(Info, TellsOfTheSceneAskedFor) {
    InfoOptions o = write(R"({"asset":{"version":"2.0"},"nodes":[{},{"name":"inside"}],
        "scenes":[{"nodes":[0]},{"name":"b","nodes":[1]}]})");
    EXPECT_NE(run(o).text.find("scene 0 of 2\n"), std::string::npos);
    for (const char* wanted : {"b", "1"}) {
        o.load.scene = wanted;
        const std::string text = run(o).text;
        EXPECT_NE(text.find("scene 1 of 2 \"b\""), std::string::npos) << text;
        EXPECT_NE(text.find("inside"), std::string::npos) << text;
    }
}

// Warnings of flattening name the file's node, not its index in the scene.
TEST_F(Info, WarningsAfterLoadingHaveAPlace) {
    InfoOptions o = write(R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual"],
        "extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional"}]}},
        "scenes":[{"nodes":[1]}],"nodes":[{"scale":[0,0,0],
        "extensions":{"KHR_lights_punctual":{"light":0}}},{"children":[0]}]})");
    EXPECT_NE(run(o).text.find("Warnings (1)\n  /nodes/0: "), std::string::npos) << run(o).text;
    o.json = true;
    const Printed printed = run(o);
    EXPECT_EQ(printed.code, 10);
    expect_fits_schema(printed.text);
    EXPECT_NE(printed.text.find(R"("place": "/nodes/0")"), std::string::npos) << printed.text;
    EXPECT_NE(printed.text.find(R"("file_index": 1)"), std::string::npos) << printed.text;
}

TEST_F(Info, RefusedFilesAsJson) {
    for (const char* text : {"hello", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":1}]})"}) {
        const Printed printed = run(write(text, true));
        EXPECT_EQ(printed.code, int(ExitCode::invalid));
        expect_fits_schema(printed.text);
        EXPECT_NE(printed.text.find(R"("result": "refused")"), std::string::npos) << printed.text;
        EXPECT_NE(printed.text.find(R"("scene": null)"), std::string::npos) << printed.text;
    }
}

TEST_F(Info, TellsOfInstancesAndHiddenNodes) {
    InfoReport report;
    report.file.emplace();
    report.scene.emplace();
    report.scene->meshes.resize(1);
    report.scene->nodes.resize(2);
    report.scene->nodes[0].name = "rocks";
    report.scene->nodes[0].mesh = 0;
    report.scene->nodes[0].instances.resize(12, glm::mat4(1));
    report.scene->nodes[1].name = "ghost";
    report.scene->nodes[1].visible = false;
    report.flat = flatten(*report.scene, {}, {}, report.diagnostics);
    const std::string text = info_text(report);
    EXPECT_NE(text.find("rocks [mesh 0] x 12\n"), std::string::npos) << text;
    EXPECT_NE(text.find("ghost (hidden"), std::string::npos) << text;
    EXPECT_NE(text.find("12 instances of 1 mesh"), std::string::npos) << text;
    expect_fits_schema(info_json(report));
}

// Very many nodes one inside the other must neither fill the terminal nor the memory.
TEST_F(Info, LongListsAreCut) {
    std::string nodes;
    constexpr int kDepth = 20000;
    for (int i = 0; i < kDepth; ++i)
        nodes +=
            (i == 0 ? "" : ",") + std::string("{\"children\":[") + std::to_string(i + 1) + "]}";
    const Printed printed = run(write(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],)"
                                      R"("nodes":[)" +
                                      nodes + ",{}]}"));
    EXPECT_EQ(printed.code, 0);
    EXPECT_LT(printed.text.size(), 20000u);
    EXPECT_NE(printed.text.find("... and 19901 more; --json lists all"), std::string::npos);
}

}  // namespace
