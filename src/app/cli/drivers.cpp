#include "app/cli/drivers.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string_view>
#include <system_error>

namespace hm::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAddDrivers = "VK_ADD_DRIVER_FILES";

// Container runtimes and package systems that keep drivers apart put manifests here.
constexpr std::array<const char*, 5> kOtherFolders = {
    "/usr/local/nvidia/share/vulkan/icd.d", "/usr/local/nvidia/vulkan/icd.d",
    "/run/opengl-driver/share/vulkan/icd.d", "/usr/lib/x86_64-linux-gnu/GL/vulkan/icd.d",
    "/usr/lib/wsl/lib"};

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    std::istringstream text(list);
    for (std::string part; std::getline(text, part, ':');)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

// The XDG base directories and /etc, as the loader's own documentation orders them.
std::vector<std::string> searched_folders(const Environment& environment) {
    const std::string home = environment("HOME");
    const auto either = [&](const char* name, const std::string& otherwise) {
        const std::string value = environment(name);
        return split(value.empty() ? otherwise : value);
    };
    std::vector<std::string> folders;
    const auto append = [&](const std::vector<std::string>& more) {
        for (const std::string& folder : more)
            folders.push_back(folder + "/vulkan/icd.d");
    };
    append(either("XDG_CONFIG_HOME", home.empty() ? "" : home + "/.config"));
    append(either("XDG_CONFIG_DIRS", "/etc/xdg"));
    append({"/etc"});
    append(either("XDG_DATA_HOME", home.empty() ? "" : home + "/.local/share"));
    append(either("XDG_DATA_DIRS", "/usr/local/share:/usr/share"));
    return folders;
}

// The only value of interest in a manifest.
std::string library_of(const fs::path& manifest) {
    std::ifstream file(manifest);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    static const std::regex kLibrary(R"re("library_path"\s*:\s*"([^"]+)")re");
    std::smatch match;
    if (!std::regex_search(text, match, kLibrary)) return "";
    const fs::path library = match[1].str();
    const bool is_relative = library.has_parent_path() && library.is_relative();
    return is_relative ? (manifest.parent_path() / library).lexically_normal() : library;
}

void add_file(const fs::path& file, bool is_searched, std::vector<DriverManifest>& manifests) {
    const auto is_same = [&](const DriverManifest& m) { return m.file == file; };
    if (std::any_of(manifests.begin(), manifests.end(), is_same)) return;
    manifests.push_back({file, library_of(file), is_searched});
}

void add_folder(const fs::path& folder, bool is_searched, std::vector<DriverManifest>& manifests) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files)
        add_file(file, is_searched, manifests);
}

// The user's own list of files and folders; empty if there is none.
std::vector<std::string> chosen_drivers(const Environment& environment) {
    const std::string files = environment("VK_DRIVER_FILES");
    return split(files.empty() ? environment("VK_ICD_FILENAMES") : files);
}

void add_listed(const std::vector<std::string>& list, std::vector<DriverManifest>& manifests) {
    std::error_code error;
    for (const std::string& path : list)
        fs::is_directory(path, error) ? add_folder(path, true, manifests)
                                      : add_file(path, true, manifests);
}

}  // namespace

std::string process_environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

std::vector<DriverManifest> find_manifests(const Environment& environment, const fs::path& root) {
    std::vector<DriverManifest> manifests;
    const std::vector<std::string> chosen = chosen_drivers(environment);
    const auto below_root = [&](const std::string& path) { return root / path.substr(1); };
    if (!chosen.empty()) {
        add_listed(chosen, manifests);
    } else {
        add_listed(split(environment(kAddDrivers)), manifests);
        for (const std::string& folder : searched_folders(environment))
            add_folder(below_root(folder), true, manifests);
    }
    for (const char* folder : kOtherFolders)
        add_folder(below_root(folder), false, manifests);
    return manifests;
}

std::string library_trouble(const std::string& library) {
    void* handle = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (handle == nullptr) {
        const char* reason = ::dlerror();
        return reason != nullptr ? reason : library + " can't be opened";
    }
    ::dlclose(handle);
    return "";
}

std::string manifest_trouble(const DriverManifest& manifest) {
    std::error_code error;
    if (!fs::exists(manifest.file, error)) return "there is no such file";
    const std::string& library = manifest.driver;
    if (library.empty()) return "the manifest names no library";
    if (std::string trouble = library_trouble(library); !trouble.empty()) return trouble;
    void* handle = ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL);
    const bool is_driver = ::dlsym(handle, "vk_icdGetInstanceProcAddr") != nullptr;
    ::dlclose(handle);
    return is_driver ? ""
                     : library + " is not a Vulkan driver: it has no vk_icdGetInstanceProcAddr";
}

std::string drivers_to_add(const std::vector<DriverManifest>& manifests,
                           const Environment& environment) {
    if (!chosen_drivers(environment).empty()) return "";
    std::string list;
    for (const DriverManifest& hidden : manifests) {
        const auto is_same_driver = [&](const DriverManifest& m) {
            return m.is_searched &&
                   fs::path(m.driver).filename() == fs::path(hidden.driver).filename();
        };
        if (hidden.is_searched || hidden.driver.empty() ||
            std::any_of(manifests.begin(), manifests.end(), is_same_driver))
            continue;
        if (!list.empty()) list += ':';
        list += hidden.file.string();
    }
    return list;
}

void add_hidden_drivers() {
    const std::string list =
        drivers_to_add(find_manifests(process_environment), process_environment);
    if (list.empty()) return;
    const std::string before = process_environment(kAddDrivers);
    ::setenv(kAddDrivers, fmt::format("{}{}{}", before, before.empty() ? "" : ":", list).c_str(),
             1);
}

}  // namespace hm::cli
