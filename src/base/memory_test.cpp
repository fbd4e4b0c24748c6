// Advice to the system about memory changes no byte of it, wherever it begins and ends.
#include "base/memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hm {
namespace {

TEST(Memory, AdviceLeavesTheBytesAlone) {
    std::vector<std::byte> bytes(4 * kHugePage + 123, std::byte(0x5A));
    for (const std::size_t begin : {std::size_t(0), std::size_t(1), kHugePage - 1, kHugePage + 17})
        for (const std::size_t size :
             {std::size_t(0), std::size_t(1), kHugePage - 1, kHugePage, 2 * kHugePage + 5})
            prefer_huge_pages(bytes.data() + begin, size);
    prefer_huge_pages(nullptr, 0);
    EXPECT_EQ(std::count(bytes.begin(), bytes.end(), std::byte(0x5A)),
              std::ptrdiff_t(bytes.size()));
}

}  // namespace
}  // namespace hm
