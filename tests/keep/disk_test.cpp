// Full disks, read-only folders and folders that disappear: reported before the first sample if
// possible; the old file stays intact and the samples are kept in the checkpoint.
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "keep/pictures.h"
#include "keep/program.h"

namespace hm::test {
namespace {

namespace fs = std::filesystem;

constexpr int kUnwritable = 6;

// A file size limit (RLIMIT_FSIZE) fails in the middle of a write, like a full disk.
std::function<void()> limit_files(rlim_t bytes) {
    return [bytes] {
        const struct rlimit limit { bytes, bytes };
        ::setrlimit(RLIMIT_FSIZE, &limit);
    };
}

// Root can write anywhere, so drop privileges.
void become_nobody() {
    constexpr uid_t kNobody = 65534;
    if (::getuid() != 0) return;
    if (::setgroups(0, nullptr) != 0 || ::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)
        ::_exit(99);
}

std::ptrdiff_t entries(const Folder& folder) {
    return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
}

TEST(Disk, FullWhenThePictureIsWritten) {
    const Folder folder;
    const std::string output = folder / "picture.exr", other = folder / "picture.png";
    std::ofstream(output) << "old";
    const Arguments arguments = with(small_render(output, 2), {"-o", other});
    const Outcome outcome = run(arguments, limit_files(8000));
    EXPECT_EQ(outcome.code, kUnwritable) << outcome.text;
    EXPECT_NE(outcome.text.find("error: " + output + ": can't be written: File too large\n"),
              std::string::npos)
        << outcome.text;
    EXPECT_EQ(bytes_of(output), "old");
    EXPECT_GT(fs::file_size(other), 100u);  // the smaller one fits
    EXPECT_EQ(entries(folder), 2);
}

TEST(Disk, TooFullForTheCheckpointIsSaidBeforehand) {
    const Folder folder;
    const std::string checkpoint = folder / "kept.exr";
    // Would never finish.
    const Arguments arguments =
        with(small_render(folder / "picture.exr", 1 << 24), {"--checkpoint", checkpoint});
    const Outcome outcome = run(arguments, limit_files(20000));
    EXPECT_EQ(outcome.code, kUnwritable);
    EXPECT_EQ(outcome.text,
              "himalaya: error: " + checkpoint + ": can't be written: File too large\n");
    EXPECT_EQ(entries(folder), 0);
}

TEST(Disk, AReadOnlyFolderIsSaidBeforehand) {
    const Folder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec |
                                       fs::perms::others_read | fs::perms::others_exec);
    const std::string output = folder / "picture.exr";
    const Outcome outcome = run(small_render(output, 1 << 24), become_nobody);
    fs::permissions(folder.path(), fs::perms::owner_all);
    EXPECT_EQ(outcome.code, kUnwritable);
    EXPECT_EQ(outcome.text,
              "himalaya: error: " + output + ": can't be written: Permission denied\n");
}

// Like a network mount that is gone when the image is written.
TEST(Disk, AFolderThatVanishesCostsNoSample) {
    const Folder folder;
    const std::string target = folder / "mount", output = target + "/picture.exr";
    const std::string checkpoint = folder / "kept.exr";
    fs::create_directory(target);
    const Arguments arguments =
        with(small_render(output, 400), {"--checkpoint", checkpoint, "--every", "0.02"});
    Program program(arguments);
    while (!fs::exists(checkpoint) && program.is_running())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    fs::remove(target);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.code, kUnwritable);
    EXPECT_NE(outcome.text.find("error: " + output +
                                ": can't be written: there is no such folder; the samples are kept "
                                "in " +
                                checkpoint + ", --resume writes again\n"),
              std::string::npos)
        << outcome.text;
    fs::create_directory(target);
    EXPECT_EQ(run(with(arguments, {"--resume", checkpoint})).code, 0);
    ASSERT_EQ(run(small_render(folder / "whole.exr", 400)).code, 0);
    expect_same_pixels(output, folder / "whole.exr");
}

// A checkpoint that can't be written does not stop rendering, but is reported.
TEST(Disk, ACheckpointThatVanishesIsWarnedOf) {
    const Folder folder;
    const std::string target = folder / "mount", checkpoint = target + "/kept.exr";
    const std::string output = folder / "picture.exr";
    fs::create_directory(target);
    const Arguments arguments =
        with(small_render(output, 400), {"--checkpoint", checkpoint, "--every", "0.02"});
    Program program(arguments);
    while (!fs::exists(checkpoint) && program.is_running())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    fs::rename(target, folder / "elsewhere");
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.code, kUnwritable);
    EXPECT_NE(outcome.text.find("warning: " + checkpoint + ": can't be written: there is no such"),
              std::string::npos)
        << outcome.text;
    ASSERT_EQ(run(small_render(folder / "whole.exr", 400)).code, 0);
    expect_same_pixels(output, folder / "whole.exr");
}

}  // namespace
}  // namespace hm::test
