// --checkpoint and --resume: the same pixels regardless of interruptions, adding more samples
// later, sequences that resume at the interrupted frame, and the error messages of rejected
// checkpoints.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "film/store.h"
#include "keep/pictures.h"
#include "keep/program.h"

namespace hm::test {
namespace {

namespace fs = std::filesystem;

void expect_ok(const Arguments& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
}

// Expects that this one line is the program's only output.
void expect_refused(const Arguments& arguments, const std::string& message, int code = 2) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.text, "himalaya: error: " + message + "\n");
}

class Resume : public testing::Test {
  protected:
    Folder folder;
    const std::string output = folder / "picture.exr";
    const std::string whole = folder / "whole.exr";
    const std::string checkpoint = folder / "kept.exr";
};

TEST_F(Resume, FewerSamplesThenMoreAreAllAtOnce) {
    expect_ok(small_render(whole, 37));
    expect_ok(with(small_render(output, 5), {"--checkpoint", checkpoint}));
    for (const int samples : {5, 6, 20, 37})
        expect_ok(with(small_render(output, samples), {"--resume", checkpoint}));
    expect_same_pixels(output, whole);
    // With another thread count, an interval that cuts every pass short, and a checkpoint copy.
    fs::remove(checkpoint);
    expect_ok(with(small_render(output, 3), {"--checkpoint", checkpoint}));
    const std::string second = folder / "second.exr";
    expect_ok(with(small_render(output, 37), {"--resume", checkpoint, "--checkpoint", second,
                                              "--every", "0.01", "--threads", "3"}));
    expect_same_pixels(output, whole);
    EXPECT_EQ(read_film(checkpoint)->film.mean_samples(), 3);
    EXPECT_EQ(read_film(second)->film.mean_samples(), 37);
}

// A time limit cuts a pass short and leaves pixels with different sample counts.
TEST_F(Resume, AfterTimeWasOver) {
    const Arguments large = {"--size", "150x90"};
    expect_ok(with(small_render(whole, 40), large));
    expect_ok(with(small_render(output, 40),
                   with(large, {"--time", "0.001", "--checkpoint", checkpoint})));
    EXPECT_GE(read_film(checkpoint)->film.fewest_samples(), 1u);
    expect_ok(
        with(small_render(output, 40), with(large, {"--time", "0.3", "--resume", checkpoint})));
    expect_ok(with(small_render(output, 40), with(large, {"--resume", checkpoint})));
    expect_same_pixels(output, whole);
}

TEST_F(Resume, ACropOfAClampedPictureWithAnotherSampler) {
    const Arguments more = {"--size", "80x60",     "--crop",      "13,7,60,51",   "--clamp",
                            "0.5",    "--sampler", "independent", "--background", "transparent"};
    expect_ok(with(small_render(whole, 11), more));
    expect_ok(with(small_render(output, 4), with(more, {"--checkpoint", checkpoint})));
    expect_ok(with(small_render(output, 11), with(more, {"--resume", checkpoint})));
    expect_same_pixels(output, whole);
}

TEST_F(Resume, ASequenceGoesOnWithTheFrameThatWasDrawn) {
    const Arguments frames = {"--frames", "3:6"};
    const std::string pattern = folder / "f#.exr";
    expect_ok(with(small_render(folder / "whole#.exr", 60), frames));
    const Arguments kept = with(small_render(pattern, 60),
                                {"--frames", "3:6", "--checkpoint", checkpoint, "--every", "0.02"});
    {
        Program program(kept);
        while (!fs::exists(folder / "f4.exr") && program.is_running())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.send(SIGKILL);
        program.wait();
    }
    fs::remove(folder / "f3.exr");
    expect_ok(with(kept, {"--resume", checkpoint}));
    EXPECT_FALSE(fs::exists(folder / "f3.exr")) << "finished before, and drawn again";
    for (const char* n : {"4", "5", "6"})
        expect_same_pixels(folder / ("f" + std::string(n) + ".exr"),
                           folder / ("whole" + std::string(n) + ".exr"));
    expect_refused(with(small_render(pattern, 60), {"--frames", "0:5", "--resume", checkpoint}),
                   checkpoint + ": is of frame 6, which --frames 0:5 does not have");
    expect_refused(with(small_render(pattern, 61), {"--frames", "3:6", "--resume", checkpoint}),
                   checkpoint + ": is of a sequence with --spp 60 (now 61)");
    expect_refused(with(small_render(output, 60), {"--resume", checkpoint}),
                   checkpoint + ": is of frame 6 of a sequence; give --frames");
}

TEST_F(Resume, OtherPicturesAreRefused) {
    expect_ok(with(small_render(output, 4), {"--checkpoint", checkpoint}));
    const auto refuse = [&](const Arguments& more, const std::string& why, int samples = 4) {
        expect_refused(with(small_render(output, samples), with({"--resume", checkpoint}, more)),
                       checkpoint + ": " + why);
    };
    const std::string other = "is of another picture: ";
    refuse({"--seed", "2"}, other + "seed 0 (now 2)");
    refuse({"--size", "32x33"}, other + "size 32x32 (now 32x33)");
    refuse({"--crop", "0,0,8,8"}, other + "no crop (now 0,0,8,8)");
    refuse({"--bounces", "2", "--clamp", "1.5"}, other + "bounces 8 (now 2), clamp 0 (now 1.5)");
    refuse({"--eye", "0,0,1", "--fov", "30"}, other + "no eye (now 0,0,1), no fov (now 30)");
    expect_ok(small_render(folder / "sky.hdr", 1));
    refuse({"--env", folder / "sky.hdr"}, other + "the environment differs");
    refuse({}, "has samples up to 4 already; 3 is less", 3);
}

TEST_F(Resume, AnotherSceneIsRefused) {
    const char* kScene = R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{}]})";
    const std::string scene = folder / "scene.gltf";
    const Arguments draw = {"render", "--quiet", scene,      "-o",  output,     "--size",  "8x8",
                            "--spp",  "2",       "--device", "cpu", "--resume", checkpoint};
    std::ofstream(scene) << kScene;
    expect_ok(with(draw, {"--checkpoint", checkpoint}));
    expect_ok(draw);
    std::ofstream(scene) << kScene << " ";
    expect_refused(
        draw, checkpoint + ": is of another picture: the scene file differs, or one that it reads");
}

TEST_F(Resume, FlagsThatMakeNoSense) {
    expect_ok(with(small_render(output, 1), {"--checkpoint", checkpoint}));
    expect_refused(
        with(small_render(output, 1), {"--checkpoint", checkpoint}),
        checkpoint + ": exists already: continue it with --resume, or remove it to start over");
    expect_refused(with(small_render(output, 1), {"--resume", folder / "gone.exr"}),
                   folder / "gone.exr" + ": can't be opened: No such file or directory", 3);
    expect_ok(small_render(whole, 1));
    expect_refused(with(small_render(output, 1), {"--resume", whole}),
                   whole + ": is a picture, not a checkpoint or a part of a rendering", 4);
    expect_refused(with(small_render(output, 1), {"--every", "5"}),
                   "--every: is for --checkpoint and --resume");
    expect_refused(with(small_render(output, 1), {"--any-device"}),
                   "--any-device: is for --resume");
    expect_refused(with(small_render(output, 1), {"--checkpoint", output}),
                   "--checkpoint: \"" + output + "\" is an output, too");
    expect_refused(with(small_render(output, 1), {"--checkpoint", folder / "no/kept.exr"}),
                   folder / "no/kept.exr" + ": can't be written: there is no such folder", 6);
}

// A checkpoint records its device; this one claims to be from a GPU.
TEST_F(Resume, AnotherDeviceNeedsAFlag) {
    expect_ok(small_render(whole, 6));
    expect_ok(with(small_render(output, 4), {"--checkpoint", checkpoint}));
    auto stored = read_film(checkpoint);
    ASSERT_TRUE(stored);
    for (auto& [name, value] : stored->label.notes)
        if (name == "device.0") value = "NVIDIA H200";
    ASSERT_TRUE(write_film(checkpoint, stored->film, stored->label, ExrCompression::none));
    expect_refused(with(small_render(output, 6), {"--resume", checkpoint}),
                   checkpoint +
                       ": was rendered by NVIDIA H200; continuing with CPU would give the bits of "
                       "neither, and --any-device does it");
    expect_ok(with(small_render(output, 6), {"--resume", checkpoint, "--any-device"}));
    expect_same_pixels(output, whole);
    EXPECT_NE(bytes_of(output).find("NVIDIA H200, then CPU"), std::string::npos);
}

}  // namespace
}  // namespace hm::test
