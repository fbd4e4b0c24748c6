// The values of flags.
#include "app/cli/values.h"

#include <gtest/gtest.h>

namespace hm::cli {
namespace {

TEST(DeviceChoice, IsReadOrRefused) {
    EXPECT_EQ(parse_device("auto")->kind, DeviceChoice::Kind::automatic);
    EXPECT_EQ(parse_device("cpu")->kind, DeviceChoice::Kind::cpu);
    EXPECT_EQ(parse_device("vulkan")->kind, DeviceChoice::Kind::vulkan);
    EXPECT_FALSE(parse_device("vulkan")->index);
    EXPECT_EQ(parse_device("vulkan:12")->index, 12u);
    for (const char* wrong : {"", "gpu", "vulkan:", "vulkan:-1", "vulkan:x", "vulkan:1 ", "CPU"})
        EXPECT_FALSE(parse_device(wrong)) << wrong;
}

}  // namespace
}  // namespace hm::cli
