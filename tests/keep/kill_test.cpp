// kill -9 at random times, a hundred times: the checkpoint is always complete and never loses
// samples, and the final image is bit-identical to that of an uninterrupted rendering.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <random>
#include <thread>

#include "film/store.h"
#include "keep/pictures.h"
#include "keep/program.h"

namespace hm::test {
namespace {

constexpr int kKills = 100;
constexpr int kSamples = 150;

// Number of samples in a checkpoint, or 0 if it does not exist yet.
double samples_in(const std::string& checkpoint) {
    if (!std::filesystem::exists(checkpoint)) return 0;
    const auto stored = read_film(checkpoint);
    EXPECT_TRUE(stored) << stored.error().line();
    return stored ? stored->film.mean_samples() : 0;
}

TEST(Kill, AtAnyMomentLosesLittleAndCorruptsNothing) {
    const Folder folder;
    const std::string output = folder / "killed.exr", checkpoint = folder / "kept.exr";
    ASSERT_EQ(run(small_render(folder / "whole.exr", kSamples)).code, 0);
    const Arguments killed =
        with(small_render(output, kSamples),
             {"--checkpoint", checkpoint, "--resume", checkpoint, "--every", "0.02"});
    std::mt19937 numbers(1);
    double longest = 0.1;  // seconds until a kill
    int kills = 0, renderings = 0, gone_on = 0;
    while (kills < kKills) {
        ++renderings;
        for (double before = 0;;) {
            Program program(killed);
            const double moment = std::uniform_real_distribution<>(0, longest)(numbers);
            std::this_thread::sleep_for(std::chrono::duration<double>(moment));
            program.send(SIGKILL);
            const Outcome outcome = program.wait();
            const double now = samples_in(checkpoint);
            ASSERT_GE(now, before);
            if (outcome.signal == 0) {
                ASSERT_EQ(outcome.code, 0) << outcome.text;
                break;
            }
            ++kills;
            if (now > before)
                ++gone_on;
            else
                longest *= 1.05;  // the machine is too slow to make progress
            before = now;
        }
        expect_same_pixels(output, folder / "whole.exr");
        std::filesystem::remove(checkpoint);
        std::filesystem::remove(output);
    }
    EXPECT_GT(gone_on, kKills / 10) << renderings << " renderings";
}

}  // namespace
}  // namespace hm::test
