// What NVIDIA's Vulkan driver needs besides a card: parts of itself that container runtimes may not
// mount, and libraries that minimal images do not have. Without them it lists no device and reports
// no error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/drivers.h"

namespace hm::cli {

struct LibraryFacts {
    std::string name, package;  // "libEGL.so.1"; Debian's
    std::string trouble;        // why it can't be opened
};

struct NvidiaFacts {
    std::string kernel_driver;         // version of the loaded kernel module: "580.159.04"
    std::string capabilities;          // NVIDIA_DRIVER_CAPABILITIES
    std::string user_driver;           // version of the Vulkan driver library, if it opens
    std::vector<LibraryFacts> opened;  // libraries that the driver opens, if there is one
};

// Opens the libraries that the driver would open. `has_manifest`: of NVIDIA's driver.
NvidiaFacts examine_nvidia(const Environment& environment, bool has_manifest);

bool is_nvidia(const DriverManifest& manifest);

// The container toolkit mounts parts of the driver by capability, by default without the graphics
// part.
bool lacks_graphics(std::string_view capabilities);

}  // namespace hm::cli
