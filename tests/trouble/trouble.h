// A Vulkan layer that makes calls fail as a bad machine would: out of memory, a device that is
// lost. It stands between the program and the validation layer, so what it refuses never happened
// to those below, and validation sees what the program does with the objects that it has.
//
// A test that links it says at run time what is to fail. The program itself takes it from
// HIMALAYA_TROUBLE ("VK_ERROR_DEVICE_LOST vkQueueSubmit2 3") once VK_LAYER_PATH and
// VK_INSTANCE_LAYERS name the layer (kFolder, kName).
#pragma once

#include <volk.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hm::trouble {

inline constexpr const char* kName = "VK_LAYER_HIMALAYA_trouble";

// From call number `at` (from 0) on, `function` fails with `result`; without a name the calls of
// all functions count that may return it, and the function that is reached fails from then on.
// Waiting fails but once, or nobody could know when an object is out of use. A device that is lost
// is so for all its calls; its work is let finish before, since it is not really gone. Starts
// counting anew.
void arm(VkResult result, std::uint32_t at, std::string_view function = "");
void disarm();

// The function that failed first, empty if it did not come to that.
std::string hit();

// Every function that can be made to fail.
std::vector<std::string> functions();

}  // namespace hm::trouble
