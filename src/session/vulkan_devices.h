// The only interface to the Vulkan renderer: implemented by vulkan_devices.cpp, or by
// without_vulkan.cpp in a build without that renderer.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "rhi/capabilities.h"
#include "session/devices.h"

namespace hm {

bool built_with_vulkan();

struct VulkanDevice {
    std::uint32_t index = 0;  // N of vulkan:N
    std::string name, kind;   // "NVIDIA H200", "discrete GPU"
    std::string driver, api_version;
    bool is_software = false;  // runs on the CPU
    std::uint64_t memory_bytes = 0;
    std::vector<rhi::Capability> capabilities;
};

// In the order of their indices. Fails with ErrorKind::no_device if no loader or driver is found.
Result<std::vector<VulkanDevice>> list_vulkan_devices();

// The best GPU, or the device with this index, which may be software. `diagnostics` must outlive
// it.
Result<std::unique_ptr<RenderDevice>> open_vulkan_device(std::optional<std::uint32_t> index,
                                                         Diagnostics& diagnostics);

}  // namespace hm
