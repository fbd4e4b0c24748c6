#include "app/cli/load_flags.h"

#include <gtest/gtest.h>

namespace hm::cli {
namespace {

TEST(LoadFlags, Sizes) {
    EXPECT_EQ(*parse_bytes("1"), 1u);
    EXPECT_EQ(*parse_bytes("4G"), 4ull << 30);
    EXPECT_EQ(*parse_bytes("3K"), 3072u);
    EXPECT_EQ(*parse_bytes("18446744073709551615"), ~0ull);
    for (const char* text : {"", "0", "0G", "G", "4g", "4GB", "4 G", "-1", "1.5G", "16777216T",
                             "18446744073709551616"})
        EXPECT_FALSE(parse_bytes(text)) << text;
}

}  // namespace
}  // namespace hm::cli
