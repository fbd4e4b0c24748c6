// --threads bounds every thread of the program, those of the libraries that write files included.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace {

namespace fs = std::filesystem;

// 0 once the process has ended.
int threads_of(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("Threads:")) return std::atoi(line.c_str() + 8);
    return 0;
}

// The most threads that were seen at once: looked at each millisecond, while the picture alone
// takes tens of milliseconds to compress.
int most_threads(const fs::path& picture, const char* threads) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl(HIMALAYA_PROGRAM, HIMALAYA_PROGRAM, "render", "demo:cornell", "--size", "1024x1024",
                "--spp", "1", "--bounces", "1", "--device", "cpu", "--quiet", "--threads", threads,
                "-o", picture.c_str(), nullptr);
        ::_exit(127);
    }
    int most = 0, status = 0;
    while (::waitpid(child, &status, WNOHANG) == 0) {
        most = std::max(most, threads_of(child));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    return most;
}

TEST(Threads, OneMeansOne) {
    if (!fs::exists("/proc/self/status")) GTEST_SKIP() << "threads are counted in /proc";
    const fs::path picture = fs::path(testing::TempDir()) / "cli_threads_test.exr";
    // The renderer's own, and one that sleeps until progress is due.
    EXPECT_LE(most_threads(picture, "1"), 2);
    fs::remove(picture);
}

}  // namespace
