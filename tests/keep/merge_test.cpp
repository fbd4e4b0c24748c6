// --samples and `himalaya merge`: any split merged in any order equals the whole up to float
// rounding, and incompatible parts are rejected with an error that names them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "film/store.h"
#include "keep/pictures.h"
#include "keep/program.h"

namespace hm::test {
namespace {

// Renders a range of samples of the small image.
Arguments part(const std::string& output, int begin, int end, const Arguments& more = {}) {
    return with({"render", "demo:cornell", "--size", "32x32", "--threads", "1", "--device", "cpu",
                 "--samples", std::to_string(begin) + ":" + std::to_string(end), "-o", output},
                more);
}

void expect_ok(const Arguments& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
}

class Merge : public testing::Test {
  protected:
    void expect_refused(const Arguments& parts, const std::string& message, int code = 2) {
        const Outcome outcome = run(with(with({"merge"}, parts), {"-o", folder / "all.exr"}));
        EXPECT_EQ(outcome.code, code);
        EXPECT_EQ(outcome.text, "himalaya: error: " + message + "\n");
        EXPECT_FALSE(std::filesystem::exists(folder / "all.exr"));
    }

    Folder folder;
};

// Sums of n positive floats differ by at most n roundings, plus one for the division.
TEST_F(Merge, AnySplitInAnyOrderIsTheWhole) {
    constexpr int kSamples = 24;
    std::mt19937 numbers(1);
    const Arguments clamped = {"--clamp", "2", "--background", "transparent"};
    expect_ok(with(small_render(folder / "whole.exr", kSamples), clamped));
    for (int round = 0; round < 4; ++round) {
        Arguments parts;
        for (int begin = 0; begin < kSamples;) {
            const int end = std::min(begin + 1 + int(numbers() % 10), kSamples);
            parts.push_back(folder / ("part" + std::to_string(begin) + ".exr"));
            expect_ok(part(parts.back(), begin, end, clamped));
            begin = end;
        }
        std::shuffle(parts.begin(), parts.end(), numbers);
        expect_ok(
            with(with({"merge"}, parts), {"-o", folder / "all.exr", "-o", folder / "all.png"}));
        expect_near_pixels(folder / "all.exr", folder / "whole.exr", kSamples + 1);
        EXPECT_TRUE(std::filesystem::exists(folder / "all.png"));
    }
}

TEST_F(Merge, PartsOfPartsAndCheckpoints) {
    expect_ok(small_render(folder / "whole.exr", 12));
    expect_ok(part(folder / "a.exr", 0, 3));
    expect_ok(part(folder / "b.exr", 3, 5));
    expect_ok(part(folder / "c.exr", 5, 12));
    expect_ok({"merge", folder / "c.exr", folder / "b.exr", "--part", "-o", folder / "bc.exr"});
    const auto joined = read_film(folder / "bc.exr");
    ASSERT_TRUE(joined) << joined.error().line();
    EXPECT_EQ(joined->film.first_sample, 3u);
    EXPECT_EQ(joined->film.fewest_samples(), 9u);
    expect_ok({"merge", folder / "bc.exr", folder / "a.exr", "-o", folder / "all.exr"});
    expect_near_pixels(folder / "all.exr", folder / "whole.exr", 13);
    EXPECT_NE(bytes_of(folder / "all.exr").find("--samples 0:12"), std::string::npos);
    // A part can have a checkpoint and can be resumed.
    const Arguments kept = {"--checkpoint", folder / "kept.exr"};
    expect_ok(with(part(folder / "c.exr", 5, 7), kept));
    expect_ok(with(part(folder / "c.exr", 5, 12), {"--resume", folder / "kept.exr"}));
    expect_ok({"merge", folder / "a.exr", folder / "b.exr", folder / "kept.exr", "-o",
               folder / "all.exr"});
    expect_near_pixels(folder / "all.exr", folder / "whole.exr", 13);
    // Merging just a checkpoint gives the image so far, bit for bit.
    expect_ok(with(small_render(folder / "whole.exr", 12), {"--checkpoint", folder / "w.exr"}));
    expect_ok({"merge", folder / "w.exr", "-o", folder / "all.exr"});
    expect_same_pixels(folder / "all.exr", folder / "whole.exr");
}

// Cryptomattes are ranked over all samples, so their ids are equal; the ids and UVs of the lowest
// sample index are those of the first part.
TEST_F(Merge, EveryLayer) {
    constexpr int kSamples = 16;
    const Arguments all = {"--aov", "all,variance"};
    expect_ok(with(small_render(folder / "whole.exr", kSamples), all));
    expect_ok(part(folder / "a.exr", 0, 5, all));
    expect_ok(part(folder / "b.exr", 5, 6, all));
    expect_ok(part(folder / "c.exr", 6, kSamples, all));
    expect_ok(
        {"merge", folder / "c.exr", folder / "a.exr", folder / "b.exr", "-o", folder / "all.exr"});
    expect_near_pixels(folder / "all.exr", folder / "whole.exr", kSamples + 1);
    const std::string text = bytes_of(folder / "all.exr");
    EXPECT_NE(text.find("tall block"), std::string::npos) << "the cryptomattes' manifests";
    EXPECT_NE(text.find("estimatedError"), std::string::npos);
    // Bit-identical if a single rendering is resumed.
    expect_ok(with(small_render(folder / "again.exr", 3),
                   with(all, {"--checkpoint", folder / "kept.exr"})));
    expect_ok(with(small_render(folder / "again.exr", kSamples),
                   with(all, {"--resume", folder / "kept.exr", "--every", "0.01"})));
    expect_same_pixels(folder / "again.exr", folder / "whole.exr");
}

TEST_F(Merge, WhatDoesNotFitIsRefused) {
    const std::string a = folder / "a.exr", b = folder / "b.exr";
    expect_ok(part(a, 0, 4));
    const auto refuse = [&](int begin, int end, const Arguments& more, const std::string& why) {
        expect_ok(part(b, begin, end, more));
        expect_refused({a, b}, b + ": " + why);
    };
    refuse(3, 6, {}, "has samples 3 to 6; " + a + " has 0 to 4");
    refuse(6, 8, {}, "starts at sample 6, and no part has 4 to 6");
    refuse(4, 8, {"--seed", "7"}, "is of another picture: seed 7 (" + a + " has 0)");
    refuse(4, 8, {"--size", "32x31"}, "is of another picture: size 32x31 (" + a + " has 32x32)");
    expect_refused({b}, b + ": starts at sample 4, and no part has 0 to 4");
    expect_refused({a, a}, a + ": has samples 0 to 4; " + a + " has 0 to 4");
    expect_refused({a, folder / "gone.exr"},
                   folder / "gone.exr" + ": can't be opened: No such file or directory", 3);
    expect_ok(small_render(folder / "picture.exr", 1));
    expect_refused(
        {a, folder / "picture.exr"},
        folder / "picture.exr" + ": is a picture, not a checkpoint or a part of a rendering", 4);
    const Outcome lost = run({"merge", a, "-o", a});
    EXPECT_EQ(lost.text, "himalaya: error: " + a + ": is one of the parts; it would be lost\n");
    EXPECT_TRUE(read_film(a));
}

// Other programs can read a part.
TEST_F(Merge, OpenImageIoReadsParts) {
    if (std::system("command -v oiiotool >/dev/null") != 0) GTEST_SKIP() << "there is no oiiotool";
    expect_ok(part(folder / "a.exr", 0, 4, {"--crop", "3,4,19,24"}));
    const std::string text = folder / "info.txt";
    ASSERT_EQ(
        std::system(("oiiotool --info -v '" + (folder / "a.exr") + "' >'" + text + "'").c_str()),
        0);
    const std::string info = bytes_of(text);
    for (const char* expected :
         {"16 x   20, 6 channel, float openexr", "sum.R", "sum.A", "sum.removed", "sum.weight",
          "pixel data origin: x=3, y=4", "full/display size: 32 x 32", "film.version: \"1\"",
          "film.first_sample: \"0\"", "setting.seed: \"0\""})
        EXPECT_NE(info.find(expected), std::string::npos) << expected << "\n" << info;
}

}  // namespace
}  // namespace hm::test
