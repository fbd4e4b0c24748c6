// The manifests by which the Vulkan loader finds drivers: small JSON files that name a library.
// Containers often have them where the loader does not search.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hm::cli {

struct DriverManifest {
    std::filesystem::path file;
    std::string driver;        // the library as it is to be opened: a name or a path
    bool is_searched = true;   // the loader looks there by itself
    std::string trouble = {};  // manifest_trouble, where it was tried
};

// An environment variable's value, empty if it is not set.
using Environment = std::function<std::string(const char*)>;
std::string process_environment(const char* name);

// The manifests that the loader reads, in its order, then those in other known locations. `root` is
// prepended to absolute paths, for tests. Files without a "library_path" have no driver.
std::vector<DriverManifest> find_manifests(const Environment& environment,
                                           const std::filesystem::path& root = "/");

// Why the library can't be opened, as the system reports it; empty if it can.
std::string library_trouble(const std::string& library);

// Why the loader can't use a manifest: no file, no library named, or one that can't be opened or
// is no Vulkan driver; empty if it can.
std::string manifest_trouble(const DriverManifest& manifest);

// A value for VK_ADD_DRIVER_FILES: the manifests that the loader would not find, of drivers
// without another manifest that it finds. Empty if there are none, or if the user chose drivers.
std::string drivers_to_add(const std::vector<DriverManifest>& manifests,
                           const Environment& environment);

// Sets VK_ADD_DRIVER_FILES for this process if that adds a driver. Call it before Vulkan is used.
void add_hidden_drivers();

}  // namespace hm::cli
