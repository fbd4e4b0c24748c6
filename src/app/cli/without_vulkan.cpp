// Behind vulkan_devices.h in a build without the Vulkan renderer.
#include "app/cli/vulkan_devices.h"

namespace hm::cli {
namespace {

tl::unexpected<Error> left_out() {
    return fail(ErrorKind::no_device, "", "",
                "this build leaves the Vulkan renderer out (cmake -DHIMALAYA_VULKAN=ON says what "
                "it needs)");
}

}  // namespace

bool built_with_vulkan() {
    return false;
}

Result<std::vector<VulkanDevice>> list_vulkan_devices() {
    return left_out();
}

Result<std::unique_ptr<Device>> open_vulkan_device(std::optional<std::uint32_t>, Diagnostics&) {
    return left_out();
}

}  // namespace hm::cli
