// How much memory this process may use: what the system has, or less where a control group (a
// container, a systemd slice) sets a limit.
#pragma once

#include <cstdint>
#include <filesystem>

namespace hm {

struct MemoryFacts {
    std::uint64_t total_bytes = 0;      // 0: unknown
    std::uint64_t available_bytes = 0;  // without swapping; reclaimable caches count as available
};

// The smaller of /proc/meminfo's figures and the limits of the process's control group, versions 1
// and 2, and of all groups above it. `root` stands for / in tests.
MemoryFacts memory_facts(const std::filesystem::path& root = "/");

}  // namespace hm
