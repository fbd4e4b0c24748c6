#include "base/available_memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace hm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

// Reads the number after `key` in a file of "key number" lines; an empty key reads the number at
// the start of the file.
std::optional<std::uint64_t> read_number(const fs::path& path, const std::string& key) {
    std::ifstream file(path);
    for (std::string word; key.empty() || file >> word;) {
        std::uint64_t number = 0;
        if (word != key) {
            file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
        } else if (file >> number) {
            return number;
        } else {
            return {};
        }
    }
    return {};
}

// The file names of one cgroup version.
struct Version {
    const char* mount;
    const char* limit;
    const char* usage;
    const char* reclaimable;  // in memory.stat
};
constexpr Version kVersion1 = {"sys/fs/cgroup/memory", "memory.limit_in_bytes",
                               "memory.usage_in_bytes", "total_inactive_file"};
constexpr Version kVersion2 = {"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"};

void apply_limit(const fs::path& group, const Version& version, MemoryFacts& facts) {
    const auto limit = read_number(group / version.limit, "");  // empty for "max": no limit
    if (!limit) return;
    const std::uint64_t usage = read_number(group / version.usage, "").value_or(0);
    const std::uint64_t reclaimable =
        read_number(group / "memory.stat", version.reclaimable).value_or(0);
    const std::uint64_t used = usage - std::min(usage, reclaimable);
    facts.total_bytes = std::min(facts.total_bytes, *limit);
    facts.available_bytes = std::min(facts.available_bytes, *limit - std::min(*limit, used));
}

// `name`: the cgroup's path relative to the mount. Applies the limits of the cgroup and of all its
// parents. In a container, the mount may be the container's own cgroup and the path may not exist
// below it, so this goes up to the mount itself.
void apply_limits(const fs::path& root, std::string name, const Version& version,
                  MemoryFacts& facts) {
    for (;; name.resize(name.rfind('/'))) {
        apply_limit(root / version.mount / fs::path(name).relative_path(), version, facts);
        if (name.find('/') == std::string::npos) return;
    }
}

}  // namespace

MemoryFacts memory_facts(const fs::path& root) {
    MemoryFacts facts{kUnknown, kUnknown};
    const fs::path info = root / "proc/meminfo";
    if (const auto kib = read_number(info, "MemTotal:")) facts.total_bytes = *kib * 1024;
    if (const auto kib = read_number(info, "MemAvailable:")) facts.available_bytes = *kib * 1024;

    // Lines are "hierarchy:controllers:path"; in version 2 the list of controllers is empty.
    std::ifstream groups(root / "proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
        if (controllers == ",,") apply_limits(root, line.substr(second + 1), kVersion2, facts);
        if (controllers.find(",memory,") != std::string::npos)
            apply_limits(root, line.substr(second + 1), kVersion1, facts);
    }
    if (facts.total_bytes == kUnknown) facts.total_bytes = 0;
    if (facts.available_bytes == kUnknown) facts.available_bytes = 0;
    return facts;
}

}  // namespace hm
