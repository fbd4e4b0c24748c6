// Something done again and again, with another of its Vulkan calls failing each time, until there
// is none left to fail.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/result.h"
#include "trouble/trouble.h"

namespace hm::test {

using Attempt = std::function<std::optional<Error>()>;  // the error that ended it

// Makes the loader find the layer and put it in place; before the first instance is made.
void enable_trouble_layer();

// The last attempt, in which nothing fails, must end without an error. Of the others `judge` hears
// which function failed and what came of it. Prints how many there were.
void sweep(
    VkResult result, const Attempt& attempt,
    const std::function<void(const std::string& function, const std::optional<Error>&)>& judge);

// Names VkResult, call and object, and means that a device failed or that there is none.
void expect_named(const Error& error, VkResult result);

}  // namespace hm::test
