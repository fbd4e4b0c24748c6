// The shipped scenes: where they are found, and the default flags beside them.
#include "app/cli/demo.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace hm::cli {
namespace {

namespace fs = std::filesystem;
using Flags = std::vector<std::pair<std::string, std::string>>;

TEST(Demo, FlagsAreAnObjectOfStrings) {
    EXPECT_EQ(parse_flags(R"({"size": "64x32", "env": "none"})", "a.json").value(),
              (Flags{{"size", "64x32"}, {"env", "none"}}));
    EXPECT_TRUE(parse_flags("{}", "a.json").value().empty());
}

TEST(Demo, OtherJsonIsRefused) {
    struct Refusal {
        const char *json, *location;
    };
    for (const auto& [json, location] :
         {Refusal{"", ""}, Refusal{"[]", ""}, Refusal{R"({"spp": 64})", "/spp"},
          Refusal{R"({"denoise": null})", "/denoise"}, Refusal{R"({"a":"b","a":"c"})", "/a"}}) {
        const auto flags = parse_flags(json, "a.json");
        ASSERT_FALSE(flags) << json;
        EXPECT_EQ(flags.error().kind, ErrorKind::invalid) << json;
        EXPECT_EQ(flags.error().file, "a.json") << json;
        EXPECT_EQ(flags.error().location, location) << json;
    }
}

// A folder of two scenes, named by HIMALAYA_SCENES.
class DemoFolder : public ::testing::Test {
  protected:
    DemoFolder()
        : folder_(fs::temp_directory_path() / ("demo_test-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        std::ofstream(folder_ / "plain.glb");
        std::ofstream(folder_ / "lit.glb");
        std::ofstream(folder_ / "lit.json") << R"({"spp": "8", "env": "sky.hdr"})";
        ::setenv("HIMALAYA_SCENES", folder_.c_str(), 1);
    }
    ~DemoFolder() override {
        ::unsetenv("HIMALAYA_SCENES");
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    fs::path folder_;
};

TEST_F(DemoFolder, TheEnvironmentIsBesideTheScene) {
    EXPECT_TRUE(find_demo("plain").value().flags.empty());
    const Demo lit = find_demo("lit").value();
    EXPECT_EQ(lit.scene, folder_ / "lit.glb");
    EXPECT_EQ(lit.flags, (Flags{{"spp", "8"}, {"env", (folder_ / "sky.hdr").string()}}));
}

TEST_F(DemoFolder, UnknownNamesListTheKnownOnes) {
    for (const char* name : {"gone", "", "../demo", ".plain"}) {
        const auto demo = find_demo(name);
        ASSERT_FALSE(demo) << name;
        EXPECT_EQ(demo.error().kind, ErrorKind::unreadable);
        EXPECT_NE(demo.error().message.find("demo:lit, demo:plain"), std::string::npos)
            << demo.error().message;
    }
}

TEST_F(DemoFolder, InvalidFlagsAreAnError) {
    std::ofstream(folder_ / "lit.json") << "[]";
    EXPECT_EQ(find_demo("lit").error().file, (folder_ / "lit.json").string());
}

}  // namespace
}  // namespace hm::cli
