// Makes the sweeps of tests/render over sizes and places draw on a Vulkan device.
#include "gpu/renderers.h"
#include "rhi/test_device.h"
#include "support/pictures.h"

namespace hm::test {
namespace {

class OnVulkan : public ::testing::Environment {
  public:
    void SetUp() override {
        backend() = {[](const FlatScene& flat, unsigned) -> std::unique_ptr<Renderer> {
                         return rhi::test::value_of(VulkanRenderer::create(gpu_context(), flat));
                     },
                     false};
    }
    void TearDown() override { expect_no_messages(); }
};

[[maybe_unused]] const auto* const kOnVulkan = ::testing::AddGlobalTestEnvironment(new OnVulkan);

}  // namespace
}  // namespace hm::test
