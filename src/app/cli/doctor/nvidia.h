// What NVIDIA's Vulkan driver needs beside a card: parts of itself that container runtimes leave
// out, and libraries that minimal images lack. Without them it offers no device and no reason.
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
    std::string kernel_driver;         // the version, where its module is loaded: "580.159.04"
    std::string capabilities;          // NVIDIA_DRIVER_CAPABILITIES
    std::string user_driver;           // version of the Vulkan driver's own library, where it opens
    std::vector<LibraryFacts> opened;  // what the driver opens by itself; where there is one
};

// Opens the libraries that the driver would open. `has_manifest`: of NVIDIA's driver.
NvidiaFacts examine_nvidia(const Environment& environment, bool has_manifest);

bool is_nvidia(const DriverManifest& manifest);

// The container toolkit hands out the driver's parts by capability, and by default not the graphics
// part.
bool lacks_graphics(std::string_view capabilities);

}  // namespace hm::cli
