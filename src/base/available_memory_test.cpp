#include "base/available_memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace hm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMiB = 1 << 20;

// Uses a temporary folder in place of /.
class AvailableMemory : public ::testing::Test {
  protected:
    void SetUp() override {
        put("proc/meminfo",
            "MemTotal:        8388608 kB\nMemFree:   1024 kB\nMemAvailable:    4194304 kB\n");
    }
    void TearDown() override { fs::remove_all(root_); }
    void put(const std::string& path, const std::string& text) {
        fs::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }
    MemoryFacts facts() const { return memory_facts(root_); }

  private:
    fs::path root_ =
        fs::temp_directory_path() / ("available_memory_test." + std::to_string(::getpid()));
};

TEST_F(AvailableMemory, WithoutControlGroupsIsTheSystems) {
    EXPECT_EQ(facts().total_bytes, 8192 * kMiB);
    EXPECT_EQ(facts().available_bytes, 4096 * kMiB);
}

TEST_F(AvailableMemory, IsUnknownWithoutProc) {
    EXPECT_EQ(memory_facts("/nowhere").total_bytes, 0u);
    EXPECT_EQ(memory_facts("/nowhere").available_bytes, 0u);
}

TEST_F(AvailableMemory, IsLimitedByAnyGroupAboveInVersion2) {
    put("proc/self/cgroup", "0::/user.slice/job.scope\n");
    put("sys/fs/cgroup/user.slice/job.scope/memory.max", "max\n");
    put("sys/fs/cgroup/user.slice/memory.max", std::to_string(2048 * kMiB) + "\n");
    put("sys/fs/cgroup/user.slice/memory.current", std::to_string(1536 * kMiB) + "\n");
    put("sys/fs/cgroup/user.slice/memory.stat",
        "anon 1\nactive_file 7\ninactive_file " + std::to_string(512 * kMiB) + "\n");
    EXPECT_EQ(facts().total_bytes, 2048 * kMiB);
    EXPECT_EQ(facts().available_bytes, 1024 * kMiB);  // 512 of the 1536 MiB used are cache
}

TEST_F(AvailableMemory, FindsAContainersGroupAtTheMountInVersion1) {
    put("proc/self/cgroup", "9:cpu,cpuacct:/docker/f00\n5:memory,hugetlb:/docker/f00\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", std::to_string(1024 * kMiB) + "\n");
    put("sys/fs/cgroup/memory/memory.usage_in_bytes", std::to_string(256 * kMiB) + "\n");
    EXPECT_EQ(facts().total_bytes, 1024 * kMiB);
    EXPECT_EQ(facts().available_bytes, 768 * kMiB);
}

TEST_F(AvailableMemory, IsTheSystemsBelowALargerLimit) {
    put("proc/self/cgroup", "5:memory:/\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");  // no limit (v1)
    put("sys/fs/cgroup/memory/memory.usage_in_bytes", "1\n");
    EXPECT_EQ(facts().total_bytes, 8192 * kMiB);
    EXPECT_EQ(facts().available_bytes, 4096 * kMiB);
}

TEST_F(AvailableMemory, IsNothingAboveTheLimit) {
    put("proc/self/cgroup", "0::/\n");
    put("sys/fs/cgroup/memory.max", "1000\n");
    put("sys/fs/cgroup/memory.current", "1200\n");
    EXPECT_EQ(facts().available_bytes, 0u);
}

}  // namespace
}  // namespace hm
