#include "trouble/sweep.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "rhi/error.h"

namespace hm::test {

void enable_trouble_layer() {
    ::setenv("VK_ADD_LAYER_PATH", HIMALAYA_TROUBLE_FOLDER, 1);
    ::setenv("VK_INSTANCE_LAYERS", trouble::kName, 1);
}

void sweep(VkResult result, const Attempt& attempt,
           const std::function<void(const std::string&, const std::optional<Error>&)>& judge) {
    std::map<std::string, int> reached;
    for (std::uint32_t at = 0;; ++at) {
        trouble::arm(result, at);
        const std::optional<Error> error = attempt();
        const std::string function = trouble::hit();
        trouble::disarm();
        if (function.empty()) {
            EXPECT_FALSE(error) << error->line();
            std::printf("%s: %u calls", rhi::result_name(result).c_str(), at);
            for (const auto& [name, count] : reached)
                std::printf(", %s %d", name.c_str(), count);
            std::printf("\n");
            EXPECT_GT(at, 0u);
            return;
        }
        ++reached[function];
        SCOPED_TRACE(function + ", call " + std::to_string(at) + " of all");
        judge(function, error);
        if (testing::Test::HasFatalFailure()) return;
    }
}

void expect_named(const Error& error, VkResult result) {
    const std::string line = error.line();
    // The allocator reports some host failures as device failures.
    const bool by_allocator = line.find(": vma") != std::string::npos;
    const auto names = [&](VkResult r) {
        return line.find(" returned " + rhi::result_name(r)) != std::string::npos;
    };
    EXPECT_TRUE(names(result) || (by_allocator && names(VK_ERROR_OUT_OF_DEVICE_MEMORY))) << line;
    EXPECT_FALSE(error.location.empty()) << line;
    EXPECT_TRUE(error.kind == ErrorKind::device_failed || error.kind == ErrorKind::no_device)
        << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
}

}  // namespace hm::test
