#include "app/cli/doctor/nvidia.h"

#include <dlfcn.h>
#include <link.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace hm::cli {
namespace {

constexpr const char* kVulkanLibrary = "libGLX_nvidia.so.0";

// "NVRM version: NVIDIA UNIX x86_64 Kernel Module  580.159.04  ...": the first word that begins
// with a digit and has a dot.
std::string kernel_driver() {
    std::ifstream file("/proc/driver/nvidia/version");
    for (std::string word; file >> word;)
        if (word.front() >= '0' && word.front() <= '9' && word.find('.') != word.npos) return word;
    return "";
}

// The library's file is libGLX_nvidia.so.VERSION; what is opened is a link to it.
std::string library_version() {
    void* library = ::dlopen(kVulkanLibrary, RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) return "";
    std::string version;
    link_map* map = nullptr;
    if (::dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 && map != nullptr) {
        std::error_code error;
        const std::string file = std::filesystem::canonical(map->l_name, error).filename().string();
        const std::string start = "libGLX_nvidia.so.";
        if (file.starts_with(start)) version = file.substr(start.size());
    }
    ::dlclose(library);
    return version.find('.') != version.npos ? version : "";
}

}  // namespace

bool is_nvidia(const DriverManifest& manifest) {
    return manifest.driver.find("nvidia") != std::string::npos;
}

bool lacks_graphics(std::string_view capabilities) {
    return capabilities.find("graphics") == capabilities.npos &&
           capabilities.find("all") == capabilities.npos;
}

NvidiaFacts examine_nvidia(const Environment& environment, bool has_manifest) {
    NvidiaFacts facts;
    facts.kernel_driver = kernel_driver();
    facts.capabilities = environment("NVIDIA_DRIVER_CAPABILITIES");
    if (facts.kernel_driver.empty() && !has_manifest) return facts;
    facts.user_driver = library_version();
    facts.opened = {{"libEGL.so.1", "libegl1", ""},
                    {"libGLdispatch.so.0", "libglvnd0", ""},
                    {"libX11.so.6", "libx11-6", ""},
                    {"libXext.so.6", "libxext6", ""}};
    // Without this part there is a device, but none that traces rays.
    if (!facts.user_driver.empty())
        facts.opened.push_back({"libnvidia-rtcore.so." + facts.user_driver, "", ""});
    for (LibraryFacts& library : facts.opened)
        library.trouble = library_trouble(library.name);
    return facts;
}

}  // namespace hm::cli
