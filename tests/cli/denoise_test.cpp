// `himalaya render --denoise` and `himalaya denoise`: the contents of the files, and the errors if
// the library or a layer is missing.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/cli/denoise.h"
#include "app/cli/options.h"
#include "app/cli/render.h"
#include "image/layers.h"
#include "image/read.h"
#include "image/test_images.h"

namespace {

using namespace hm;
using namespace hm::cli;
using namespace hm::testing_images;

namespace fs = std::filesystem;

class DenoiseCommand : public ::testing::Test {
  protected:
    // As main() does, with what it prints swallowed.
    Result<void> run(std::vector<std::string> arguments) {
        std::vector<const char*> list = {"himalaya"};
        for (const std::string& argument : arguments)
            list.push_back(argument.c_str());
        HM_TRY_ASSIGN(const CommandLine line, parse_command_line(int(list.size()), list.data()));
        testing::internal::CaptureStdout();
        const Result<ExitCode> code = line.render ? render(*line.render) : denoise(*line.denoise);
        printed_ = testing::internal::GetCapturedStdout();
        if (!code) return tl::unexpected(code.error());
        EXPECT_EQ(*code, ExitCode::ok);
        return {};
    }

    Result<void> draw(std::initializer_list<std::string> more) {
        std::vector<std::string> arguments = {"render", "demo:cornell", "--size", "32x24", "--spp",
                                              "2",      "--quiet",      "--json"};
        arguments.insert(arguments.end(), more);
        return run(std::move(arguments));
    }

    std::string path(const char* name) const { return (folder_ / name).string(); }

    LayeredImage layers_in(const char* name) {
        auto picture = read_layers(path(name));
        EXPECT_TRUE(picture) << picture.error().line();
        return picture ? std::move(*picture) : LayeredImage{};
    }

    // If the library was never fetched; if it was, it has to work.
    static bool library_is_missing() {
        const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
        const bool fetched = source && fs::exists(fs::path(source) / "build/oidn/version");
        return !fetched && !Denoiser::open(DenoiseDevice::cpu, 0);
    }

    Folder folder_;
    std::string printed_;
};

void expect_equal(const LayeredImage& a, const LayeredImage& b, const std::string& layer) {
    ASSERT_TRUE(a.find(layer) && b.find(layer)) << layer;
    for (const LayerChannel& channel : a.find(layer)->channels)
        EXPECT_EQ(channel.values, b.find(layer)->find(channel.name)->values) << channel.name;
}

TEST_F(DenoiseCommand, BothPicturesAreWritten) {
    if (library_is_missing()) GTEST_SKIP() << "scripts/fetch-oidn.sh has not been run";
    const auto drawn = draw({"--denoise", "--denoise-device", "cpu", "-o", path("a.exr"), "-o",
                             path("a.png"), "--exr-half", "beauty"});
    ASSERT_TRUE(drawn) << drawn.error().line();
    EXPECT_NE(printed_.find("\"denoiser\": \"Open Image Denoise 2."), std::string::npos)
        << printed_;
    ASSERT_TRUE(draw({"-o", path("raw.exr"), "-o", path("raw.png"), "--exr-half", "beauty"}));
    const LayeredImage a = layers_in("a.exr"), raw = layers_in("raw.exr");
    expect_equal(raw, a, "");  // as rendered
    ASSERT_TRUE(a.find("denoised") && a.find("albedo") && a.find("normal"));
    EXPECT_EQ(a.find("denoised")->channels.size(), 3u);
    EXPECT_EQ(a.find("denoised")->channels[0].type, ChannelType::half);
    EXPECT_NE(a.find("denoised")->channels[0].values, a.find("")->channels[0].values);
    ASSERT_NE(a.find_metadata("denoiser"), nullptr);
    EXPECT_NE(bytes_of_file(path("a.png")), bytes_of_file(path("raw.png")));

    // The same once more, from the file.
    ASSERT_TRUE(draw({"--aov", "albedo,normal,depth", "-o", path("aovs.exr")}));
    ASSERT_TRUE(draw({"--denoise", "--denoise-device", "cpu", "-o", path("at_once.exr")}));
    const auto later = run({"denoise", path("aovs.exr"), "--device", "cpu", "-o", path("later.exr"),
                            "-o", path("later.png")});
    ASSERT_TRUE(later) << later.error().line();
    const LayeredImage once = layers_in("at_once.exr"), twice = layers_in("later.exr");
    expect_equal(once, twice, "denoised");
    expect_equal(layers_in("aovs.exr"), twice, "");
    EXPECT_TRUE(twice.find("depth"));
    EXPECT_TRUE(read_image(bytes_of_file(path("later.png")), "later.png"));
}

TEST_F(DenoiseCommand, GuidesThatAreMissingAreNamed) {
    if (library_is_missing()) GTEST_SKIP() << "scripts/fetch-oidn.sh has not been run";
    ASSERT_TRUE(draw({"--aov", "albedo", "-o", path("a.exr")}));
    const auto refused = run({"denoise", path("a.exr"), "-o", path("b.exr")});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::invalid);
    EXPECT_EQ(refused.error().file, path("a.exr"));
    EXPECT_NE(refused.error().message.find("no layer \"normal\""), std::string::npos);
    EXPECT_FALSE(fs::exists(path("b.exr")));
    ASSERT_TRUE(run({"denoise", path("a.exr"), "-o", path("b.exr"), "--without-guides"}));
    EXPECT_TRUE(layers_in("b.exr").find("denoised"));
}

TEST_F(DenoiseCommand, ATransparentBackgroundIsDenoisedToo) {
    if (library_is_missing()) GTEST_SKIP() << "scripts/fetch-oidn.sh has not been run";
    ASSERT_TRUE(draw({"--denoise", "--background", "transparent", "-o", path("a.exr")}));
    const LayeredImage a = layers_in("a.exr");
    ASSERT_TRUE(a.find("denoised")->find("A"));
    for (const float alpha : a.find("denoised")->find("A")->values)
        EXPECT_TRUE(alpha >= 0 && alpha <= 1);
}

TEST_F(DenoiseCommand, WithoutTheLibraryNothingIsRendered) {
    const char* before = std::getenv("HIMALAYA_OIDN");
    const std::string kept = before ? before : "";
    ::setenv("HIMALAYA_OIDN", "/nowhere", 1);
    const auto refused = draw({"--denoise", "-o", path("a.exr")});
    const auto plain = draw({"-o", path("b.exr")});
    before ? ::setenv("HIMALAYA_OIDN", kept.c_str(), 1) : ::unsetenv("HIMALAYA_OIDN");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::no_device);
    EXPECT_NE(refused.error().message.find("scripts/fetch-oidn.sh"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("a.exr")));
    EXPECT_TRUE(plain);  // rendering does not need it
    EXPECT_TRUE(fs::exists(path("b.exr")));
}

}  // namespace
