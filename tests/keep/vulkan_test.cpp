// The same on a Vulkan device: the same pixels regardless of interruptions, parts that merge into
// the whole, and a CPU that resumes what the device rendered.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "film/store.h"
#include "keep/pictures.h"
#include "keep/program.h"

namespace hm::test {
namespace {

const Arguments kDevice = {"--device", "vulkan:0"};

Arguments on_device(const std::string& output, int samples, const Arguments& more = {}) {
    return with(with(small_render(output, samples), kDevice), more);
}

void expect_ok(const Arguments& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
}

TEST(Vulkan, ResumesToTheSamePixels) {
    const Folder folder;
    const std::string output = folder / "picture.exr", whole = folder / "whole.exr";
    const std::string checkpoint = folder / "kept.exr";
    expect_ok(on_device(whole, 40, {"--clamp", "1"}));
    expect_ok(on_device(output, 7, {"--clamp", "1", "--checkpoint", checkpoint}));
    expect_ok(on_device(output, 8, {"--clamp", "1", "--resume", checkpoint}));
    expect_ok(on_device(output, 40, {"--clamp", "1", "--resume", checkpoint, "--every", "0.01"}));
    expect_same_pixels(output, whole);
}

TEST(Vulkan, AKillLosesLittle) {
    const Folder folder;
    const std::string output = folder / "picture.exr", whole = folder / "whole.exr";
    const std::string checkpoint = folder / "kept.exr";
    constexpr int kSamples = 3000;
    {
        Program program(
            on_device(output, kSamples, {"--checkpoint", checkpoint, "--every", "0.01"}));
        while (!std::filesystem::exists(checkpoint) && program.is_running())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.send(SIGKILL);
        program.wait();
    }
    const auto stored = read_film(checkpoint);
    ASSERT_TRUE(stored) << stored.error().line();
    const int more = int(stored->film.most_samples()) + 3;
    expect_ok(on_device(output, more, {"--resume", checkpoint}));
    expect_ok(on_device(whole, more));
    expect_same_pixels(output, whole);
}

TEST(Vulkan, PartsAreTheWholeAndAnotherDeviceIsRefused) {
    const Folder folder;
    const std::string a = folder / "a.exr", b = folder / "b.exr";
    expect_ok(on_device(folder / "whole.exr", 9));
    for (const auto& [path, range] : {std::pair(a, "0:5"), std::pair(b, "5:9")})
        expect_ok(
            with({"render", "demo:cornell", "--size", "32x32", "--samples", range, "-o", path},
                 kDevice));
    expect_ok({"merge", b, a, "-o", folder / "all.exr"});
    expect_near_pixels(folder / "all.exr", folder / "whole.exr", 10);
    expect_ok(on_device(folder / "c.exr", 3, {"--checkpoint", folder / "kept.exr"}));
    const Arguments elsewhere =
        with(small_render(folder / "c.exr", 6), {"--resume", folder / "kept.exr"});
    const Outcome refused = run(elsewhere);
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.text.find("--any-device does it"), std::string::npos) << refused.text;
    expect_ok(with(elsewhere, {"--any-device"}));
}

}  // namespace
}  // namespace hm::test
