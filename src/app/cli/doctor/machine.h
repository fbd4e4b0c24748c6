// What `himalaya doctor` knows about a machine, as plain data. The checks read nothing else, so
// tests can make up machines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/doctor/nvidia.h"
#include "app/cli/drivers.h"
#include "base/available_memory.h"
#include "base/machine.h"
#include "session/vulkan_devices.h"

namespace hm::cli {

struct CpuFacts {
    std::string model;
    unsigned threads = 0;
    std::string instruction_set;  // what the stages run as: "baseline", "avx2" or "avx512"
};

// The library libvulkan.so.1.
struct LoaderFacts {
    std::string path, version;  // where it was found; "1.3.239"
    std::string trouble;        // why it can't be opened
};

// A device file of a graphics driver in /dev.
struct DeviceNode {
    std::string path;
    bool may_use = false;  // this user may read and write it
};

// The library that --denoise needs.
struct DenoiserFacts {
    std::string path;
    std::string fastest;               // "Open Image Denoise 2.5.1 on cpu (...)"
    std::vector<std::string> devices;  // "cpu (AMD EPYC)", the fastest first
    std::string trouble;               // why there is none, and how to get it
};

struct Machine {
    CpuFacts cpu;
    MemoryFacts memory;
    bool in_container = false;

    bool built_with_vulkan = true;
    LoaderFacts loader;
    std::vector<DriverManifest> manifests;
    std::string chosen_drivers;  // VK_DRIVER_FILES or VK_ICD_FILENAMES
    std::string added_drivers;   // added by this program, see drivers_to_add
    std::vector<DeviceNode> nodes;
    NvidiaFacts nvidia;

    std::vector<VulkanDevice> devices;
    std::string devices_trouble;  // why none could be listed

    DenoiserFacts denoiser;
};

// Opens drivers, which may take a while.
Machine examine_machine();

}  // namespace hm::cli
