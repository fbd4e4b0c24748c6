// Ctrl-C, SIGTERM and a closed terminal: the first signal finishes the pass, writes the image and
// exits; a second one stops immediately.
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

namespace fs = std::filesystem;

constexpr int kInterrupted = 130;

void wait_for(const std::string& file, Program& program) {
    while (!fs::exists(file) && program.is_running())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// Practically endless; the checkpoint file appears once rendering has started.
Arguments long_render(const std::string& output, const std::string& checkpoint) {
    return with(small_render(output, 1 << 24), {"--checkpoint", checkpoint, "--every", "0.05"});
}

TEST(Signals, OneFinishesThePassAndWrites) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        SCOPED_TRACE(signal);
        const Folder folder;
        const std::string output = folder / "picture.exr", checkpoint = folder / "kept.exr";
        Program program(long_render(output, checkpoint));
        wait_for(checkpoint, program);
        program.send(signal);
        const Outcome outcome = program.wait();
        EXPECT_EQ(outcome.code, kInterrupted);
        EXPECT_NE(outcome.text.find("interrupted at "), std::string::npos) << outcome.text;
        const auto stored = read_film(checkpoint);
        ASSERT_TRUE(stored) << stored.error().line();
        const std::uint32_t samples = stored->film.fewest_samples();
        EXPECT_GT(samples, 0u);
        EXPECT_EQ(samples, stored->film.most_samples());
        // The image equals one rendered with this number of samples.
        ASSERT_EQ(run(small_render(folder / "whole.exr", int(samples))).code, 0);
        expect_same_pixels(output, folder / "whole.exr");
    }
}

TEST(Signals, TwoStopAtOnce) {
    const Folder folder;
    const std::string output = folder / "picture.exr", checkpoint = folder / "kept.exr";
    // Passes of this size take seconds, so the first signal alone would not stop it quickly.
    const Arguments arguments = with(long_render(output, checkpoint), {"--size", "2000x1500"});
    Program program(arguments);
    wait_for(checkpoint, program);
    // Different signals, since equal pending signals are merged into one.
    program.send(SIGINT);
    program.send(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.code, kInterrupted);
    EXPECT_FALSE(fs::exists(output));
    EXPECT_TRUE(read_film(checkpoint));
}

TEST(Signals, AnIgnoredHangUpStaysIgnored) {
    const Folder folder;
    const std::string output = folder / "picture.exr", checkpoint = folder / "kept.exr";
    Program program(long_render(output, checkpoint), [] { ::signal(SIGHUP, SIG_IGN); });
    wait_for(checkpoint, program);
    program.send(SIGHUP);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_TRUE(program.is_running());
    program.send(SIGTERM);
    EXPECT_EQ(program.wait().code, kInterrupted);
}

// The reader of stderr may exit (SIGPIPE); the image is still written.
TEST(Signals, AClosedPipeEndsNothing) {
    const Folder folder;
    const std::string output = folder / "picture.exr";
    const Outcome outcome = run(small_render(output, 2), [] {
        int ends[2];
        if (::pipe(ends) != 0) ::_exit(1);
        ::dup2(ends[1], STDERR_FILENO);
        ::close(ends[0]);
        ::close(ends[1]);
    });
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(fs::exists(output));
}

}  // namespace
}  // namespace hm::test
