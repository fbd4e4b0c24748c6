// The report's feature tiers from what rhi requires of a device: only in builds with Vulkan.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/cli/doctor/checks.h"
#include "rhi/capabilities.h"

namespace hm::cli {
namespace {

TEST(DoctorTiers, RayQueriesAreATierThatNothingNeeds) {
    rhi::Offer offer;
    VulkanDevice device;
    for (const bool has : {false, true}) {
        if (has) offer.extensions.insert("VK_KHR_ray_query");
        device.capabilities = rhi::judge(offer);
        const auto tiers = tiers_of(device);
        const auto tier = std::find_if(tiers.begin(), tiers.end(), [](const FeatureTier& t) {
            return t.feature.find("rays from any shader") != t.feature.npos;
        });
        ASSERT_NE(tier, tiers.end());
        EXPECT_EQ(tier->missing.empty(), has);
    }
}

}  // namespace
}  // namespace hm::cli
