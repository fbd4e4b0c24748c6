// The manifests by which the Vulkan loader finds drivers: small JSON files that name a library.
// Containers often have them where the loader does not look.
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

// An environment variable's value, empty where it is not set.
using Environment = std::function<std::string(const char*)>;
std::string process_environment(const char* name);

// What the loader will read, in its order, then what lies in other places known to hold manifests.
// `root` goes before absolute paths, for tests. Files without a "library_path" have no driver.
std::vector<DriverManifest> find_manifests(const Environment& environment,
                                           const std::filesystem::path& root = "/");

// Why the library can't be opened, in the words of the system; empty if it can.
std::string library_trouble(const std::string& library);

// Why the loader can make nothing of a manifest: no file, no library named, one that can't be
// opened or is no Vulkan driver; empty if it can.
std::string manifest_trouble(const DriverManifest& manifest);

// A value for VK_ADD_DRIVER_FILES: the manifests that the loader would not find, of drivers that it
// knows by no other manifest. Empty where there are none, or where the user has chosen drivers.
std::string drivers_to_add(const std::vector<DriverManifest>& manifests,
                           const Environment& environment);

// Sets VK_ADD_DRIVER_FILES for this process where that adds a driver. Before Vulkan is first used.
void add_hidden_drivers();

}  // namespace hm::cli
