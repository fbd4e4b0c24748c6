// Implements vulkan_devices.h in a build without the Vulkan renderer.
#include "session/vulkan_devices.h"

namespace hm {
namespace {

tl::unexpected<Error> left_out() {
    return fail(ErrorKind::no_device, "", "",
                "this build lacks the Vulkan renderer (cmake -DHIMALAYA_VULKAN=ON says what it "
                "needs)");
}

}  // namespace

bool built_with_vulkan() {
    return false;
}

Result<std::vector<VulkanDevice>> list_vulkan_devices() {
    return left_out();
}

Result<std::unique_ptr<RenderDevice>> open_vulkan_device(std::optional<std::uint32_t>,
                                                         Diagnostics&) {
    return left_out();
}

}  // namespace hm
