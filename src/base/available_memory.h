// How much memory this process may use: the system's memory, or less if a control group (cgroup of
// a container or systemd slice) sets a limit.
#pragma once

#include <cstdint>
#include <filesystem>

namespace hm {

struct MemoryFacts {
    std::uint64_t total_bytes = 0;      // 0: unknown
    std::uint64_t available_bytes = 0;  // without swapping; reclaimable caches count as available
};

// The minimum of the values in /proc/meminfo and the limits of the process's cgroup (version 1 or
// 2) and all its parents. Tests replace the root directory / by `root`.
MemoryFacts memory_facts(const std::filesystem::path& root = "/");

}  // namespace hm
