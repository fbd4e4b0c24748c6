// A Vulkan layer that injects failures: out of memory, device lost. It sits between the program and
// the validation layer, so that layers below never see a failed call, and validation checks what
// the program does with the objects that it has.
//
// A test that links it chooses the failure at run time. The program itself takes it from
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

// From call number `at` (counted from 0) on, `function` fails with `result`. Without a name, calls
// of all functions that may return `result` are counted, and the one that reaches `at` fails from
// then on. Waiting fails only once, since otherwise objects in use could never be freed. A lost
// device stays lost for all calls; its work is finished first, since the real device is fine.
// Resets the count.
void arm(VkResult result, std::uint32_t at, std::string_view function = "");
void disarm();

// The function that failed first, empty if none did.
std::string hit();

// Every function that can be made to fail.
std::vector<std::string> functions();

}  // namespace hm::trouble
