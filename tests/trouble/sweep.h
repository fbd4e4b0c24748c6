// Repeats an operation with another of its Vulkan calls failing each time, until none is left.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "trouble/trouble.h"

namespace hm::test {

using Attempt = std::function<std::optional<Error>()>;  // the error that ended it

// Makes the loader find and enable the layer; call it before the first instance is created.
void enable_trouble_layer();

// The last attempt, in which nothing fails, must end without an error. For the others `judge` gets
// the function that failed and the outcome. Prints their number.
void sweep(
    VkResult result, const Attempt& attempt,
    const std::function<void(const std::string& function, const std::optional<Error>&)>& judge);

// The error names VkResult, call and object, and its kind is device_failed or no_device.
void expect_named(const Error& error, VkResult result);

}  // namespace hm::test
