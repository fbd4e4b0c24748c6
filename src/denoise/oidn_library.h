// Finding and loading Open Image Denoise. Nothing of the program needs it but denoising.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "denoise/oidn_api.h"

namespace hm::oidn {

struct Library {
    Api api;
    std::filesystem::path file;  // as the loader found it
};

struct PhysicalDevice {
    int id;
    DeviceType type;
    std::string name;
};

// The file or folder that HIMALAYA_OIDN names and nothing else; without it the folders beside the
// program, the build tree's build/oidn, and the system's libraries. The library stays loaded. Fails
// with ErrorKind::no_device and says where it looked and how to get the library.
Result<Library> load_library();

// What the library can compute on, the fastest first.
std::vector<PhysicalDevice> physical_devices(const Library& library);

// "cpu", "cuda" and so on.
const char* type_name(DeviceType type);

}  // namespace hm::oidn
