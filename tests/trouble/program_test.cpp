// The whole program with a GPU that fails. The layer makes the test device fail, and reports it as
// a discrete GPU if --device auto must take it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/cli/exit_code.h"
#include "film/store.h"
#include "image/layers.h"
#include "keep/pictures.h"
#include "keep/program.h"
#include "trouble/trouble.h"

namespace hm::test {
namespace {

namespace fs = std::filesystem;

constexpr int kSamples = 60, kManySamples = 3000;

// "VK_ERROR_DEVICE_LOST vkQueueSubmit2 3"; empty: nothing fails.
Outcome run_in(const std::string& trouble, const Arguments& arguments) {
    return run(arguments, [&] {
        ::setenv("VK_ADD_LAYER_PATH", HIMALAYA_TROUBLE_FOLDER, 1);
        ::setenv("VK_INSTANCE_LAYERS", hm::trouble::kName, 1);
        ::setenv("HIMALAYA_TROUBLE_CARD", "1", 1);
        if (!trouble.empty()) ::setenv("HIMALAYA_TROUBLE", trouble.c_str(), 1);
    });
}

std::string lost_at(int submission) {
    return "VK_ERROR_DEVICE_LOST vkQueueSubmit2 " + std::to_string(submission);
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

Arguments drawing(const std::string& device, const std::string& output) {
    return with(small_render(output, kSamples), {"--device", device});
}

// Submissions up to about the tenth upload the scene and build its structures.
class BadMachine : public testing::TestWithParam<std::string> {
  protected:
    const Folder folder_;
    const std::string output_ = folder_ / "picture.exr";
};

INSTANTIATE_TEST_SUITE_P(
    Trouble, BadMachine,
    testing::Values(lost_at(0), lost_at(5), lost_at(12), lost_at(14),
                    "VK_ERROR_DEVICE_LOST vkWaitSemaphores 30",
                    "VK_ERROR_OUT_OF_DEVICE_MEMORY vkAllocateMemory 0",
                    "VK_ERROR_OUT_OF_DEVICE_MEMORY vkCreateBuffer 20",
                    "VK_ERROR_OUT_OF_DEVICE_MEMORY vkCreateRayTracingPipelinesKHR 0"),
    [](const auto& which) { return "Case" + std::to_string(which.index); });

TEST_P(BadMachine, EndsAPictureOfANamedGpuWithItsOwnExitCode) {
    const Outcome outcome = run_in(GetParam(), drawing("vulkan", output_));
    EXPECT_EQ(outcome.code, int(cli::ExitCode::device_failed)) << outcome.text;
    const std::string result = GetParam().substr(0, GetParam().find(' '));
    EXPECT_EQ(count(outcome.text, "himalaya: error: Vulkan: "), 1) << outcome.text;
    EXPECT_EQ(count(outcome.text, " returned " + result), 1) << outcome.text;
    EXPECT_EQ(count(outcome.text, "--device cpu renders without it"), 1) << outcome.text;
    EXPECT_FALSE(fs::exists(output_));
}

TEST_P(BadMachine, LeavesAPictureOfAutoToTheCpu) {
    const Outcome outcome = run_in(GetParam(), drawing("auto", output_));
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_EQ(count(outcome.text, "himalaya: drawing on "), 1) << outcome.text;
    EXPECT_EQ(count(outcome.text, "himalaya: continuing with the CPU: Vulkan: "), 1)
        << outcome.text;
    EXPECT_EQ(count(outcome.text, "himalaya: 60 samples/pixel on CPU"), 1) << outcome.text;
    const std::string expected = folder_ / "expected.exr";
    EXPECT_EQ(run(drawing("cpu", expected)).code, 0);
    expect_same_pixels(output_, expected);
}

TEST_P(BadMachine, IsFoundByTheDoctor) {
    const Outcome outcome = run_in(GetParam(), {"doctor", "--json"});
    EXPECT_EQ(outcome.code, int(cli::ExitCode::device_failed)) << outcome.text;
}

// Checkpoints are as frequent as possible, so the film has some of the device's samples.
class Checkpoints : public testing::Test {
  protected:
    Arguments keeping(const std::string& device) const {
        return with(drawing(device, output_), {"--spp", std::to_string(kManySamples),
                                               "--checkpoint", kept_, "--every", "0.03"});
    }

    const Folder folder_;
    const std::string output_ = folder_ / "picture.exr", kept_ = folder_ / "kept.exr";
    const std::string whole_ = folder_ / "whole.exr";
};

TEST_F(Checkpoints, HoldWhatALostDeviceHadDrawn) {
    const Outcome lost = run_in(lost_at(40), keeping("vulkan"));
    EXPECT_EQ(lost.code, int(cli::ExitCode::device_failed)) << lost.text;
    EXPECT_EQ(count(lost.text, " returned VK_ERROR_DEVICE_LOST"), 1) << lost.text;
    EXPECT_EQ(count(lost.text, "; what there was by then, "), 1) << lost.text;
    EXPECT_EQ(count(lost.text, "himalaya: interrupted at "), 1) << lost.text;
    const auto stored = read_film(kept_);
    ASSERT_TRUE(stored) << stored.error().line();
    const std::uint32_t held = stored->film.most_samples();
    EXPECT_GT(held, 0u);
    EXPECT_LT(held, std::uint32_t(kManySamples));
    EXPECT_TRUE(fs::exists(output_));

    // Without failures, resuming gives the bits of an uninterrupted picture.
    const Arguments more = {"--spp", std::to_string(held + 3)};
    const Outcome resumed =
        run_in("", with(with(drawing("vulkan", output_), more), {"--resume", kept_}));
    EXPECT_EQ(resumed.code, 0) << resumed.text;
    EXPECT_EQ(run_in("", with(drawing("vulkan", whole_), more)).code, 0);
    expect_same_pixels(output_, whole_);
}

TEST_F(Checkpoints, HoldTheSamplesOfBothWhereTheCpuGoesOn) {
    const Outcome outcome = run_in(lost_at(40), keeping("auto"));
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_EQ(count(outcome.text, "himalaya: continuing with the CPU: Vulkan: "), 1)
        << outcome.text;
    EXPECT_EQ(count(outcome.text, ", then CPU"), 1) << outcome.text;
    const auto stored = read_film(kept_);
    ASSERT_TRUE(stored) << stored.error().line();
    EXPECT_EQ(stored->film.fewest_samples(), std::uint32_t(kManySamples));
    EXPECT_EQ(stored->film.most_samples(), std::uint32_t(kManySamples));
}

TEST(BadBench, SaysWhatFailed) {
    const Outcome outcome =
        run_in(lost_at(20), {"bench", "demo:cornell", "--size", "16x16", "--device", "vulkan"});
    EXPECT_EQ(outcome.code, int(cli::ExitCode::device_failed)) << outcome.text;
    EXPECT_EQ(count(outcome.text, " returned VK_ERROR_DEVICE_LOST"), 1) << outcome.text;
}

}  // namespace
}  // namespace hm::test
