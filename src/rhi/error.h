// The error for a failed Vulkan call: one line with the call, the VkResult's name and the object.
//
// ErrorKind::no_device: there is no loader, no device, or no device with the required features;
// another renderer can still render the image. ErrorKind::device_failed: a device failed while in
// use (out of memory, lost); the image is not finished.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "rhi/vulkan.h"

namespace hm::rhi {

// "VK_ERROR_DEVICE_LOST"; the number if the headers do not define it.
std::string result_name(VkResult result);

// `object` names what was created or used. Adds advice for the user if there is any.
Error device_error(VkResult result, std::string_view call, std::string_view object);

// Every VkResult that is not an error code counts as success: the caller must check for
// VK_INCOMPLETE, VK_TIMEOUT and the like.
inline Result<void> check(VkResult result, std::string_view call, std::string_view object) {
    if (result >= 0) return {};
    return tl::unexpected(device_error(result, call, object));
}

}  // namespace hm::rhi
