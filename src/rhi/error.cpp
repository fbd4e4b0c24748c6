#include "rhi/error.h"

#include <fmt/format.h>

namespace hm::rhi {

std::string result_name(VkResult result) {
    switch (result) {
#define HM_NAME(value) \
    case value:        \
        return #value
        HM_NAME(VK_SUCCESS);
        HM_NAME(VK_NOT_READY);
        HM_NAME(VK_TIMEOUT);
        HM_NAME(VK_INCOMPLETE);
        HM_NAME(VK_ERROR_OUT_OF_HOST_MEMORY);
        HM_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY);
        HM_NAME(VK_ERROR_INITIALIZATION_FAILED);
        HM_NAME(VK_ERROR_DEVICE_LOST);
        HM_NAME(VK_ERROR_MEMORY_MAP_FAILED);
        HM_NAME(VK_ERROR_LAYER_NOT_PRESENT);
        HM_NAME(VK_ERROR_EXTENSION_NOT_PRESENT);
        HM_NAME(VK_ERROR_FEATURE_NOT_PRESENT);
        HM_NAME(VK_ERROR_INCOMPATIBLE_DRIVER);
        HM_NAME(VK_ERROR_TOO_MANY_OBJECTS);
        HM_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED);
        HM_NAME(VK_ERROR_FRAGMENTED_POOL);
        HM_NAME(VK_ERROR_OUT_OF_POOL_MEMORY);
        HM_NAME(VK_ERROR_INVALID_EXTERNAL_HANDLE);
        HM_NAME(VK_ERROR_FRAGMENTATION);
        HM_NAME(VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS);
        HM_NAME(VK_ERROR_INVALID_SHADER_NV);
        HM_NAME(VK_ERROR_UNKNOWN);
#undef HM_NAME
        default:
            return fmt::format("VkResult {}", static_cast<int>(result));
    }
}

namespace {

const char* advice(VkResult result) {
    switch (result) {
        case VK_ERROR_DEVICE_LOST:
            return "; the driver reset or lost the device, which can no longer be used: see the "
                   "kernel log (dmesg)";
        case VK_ERROR_OUT_OF_DEVICE_MEMORY:
            return "; the device's memory is full";
        case VK_ERROR_OUT_OF_HOST_MEMORY:
            return "; the host's memory is full";
        default:
            return "";
    }
}

bool means_no_device(VkResult result) {
    return result == VK_ERROR_INITIALIZATION_FAILED || result == VK_ERROR_INCOMPATIBLE_DRIVER ||
           result == VK_ERROR_LAYER_NOT_PRESENT || result == VK_ERROR_EXTENSION_NOT_PRESENT ||
           result == VK_ERROR_FEATURE_NOT_PRESENT;
}

}  // namespace

Error device_error(VkResult result, std::string_view call, std::string_view object) {
    const ErrorKind kind =
        means_no_device(result) ? ErrorKind::no_device : ErrorKind::device_failed;
    return {kind, "Vulkan", std::string(object),
            fmt::format("{} returned {}{}", call, result_name(result), advice(result))};
}

}  // namespace hm::rhi
