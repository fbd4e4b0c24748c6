#include "app/cli/doctor/machine.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "cpu/render.h"
#include "denoise/denoise.h"
#include "denoise/oidn_library.h"

namespace hm::cli {
namespace {

namespace fs = std::filesystem;

bool exists(const char* path) {
    std::error_code error;
    return fs::exists(path, error);
}

bool looks_like_a_container() {
    return exists("/.dockerenv") || exists("/run/.containerenv") ||
           !process_environment("container").empty() ||
           !process_environment("KUBERNETES_SERVICE_HOST").empty();
}

// The loader tells its version by a function that needs no instance.
LoaderFacts examine_loader() {
    LoaderFacts facts;
    void* library = ::dlopen("libvulkan.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) {
        const char* reason = ::dlerror();
        facts.trouble = reason != nullptr ? reason : "libvulkan.so.1 can't be opened";
        return facts;
    }
    link_map* map = nullptr;
    if (::dlinfo(library, RTLD_DI_LINKMAP, &map) == 0 && map != nullptr) facts.path = map->l_name;
    using Version = std::int32_t(std::uint32_t*);
    const auto version = reinterpret_cast<Version*>(::dlsym(library, "vkEnumerateInstanceVersion"));
    std::uint32_t v = 0;
    if (version != nullptr && version(&v) == 0)
        facts.version = fmt::format("{}.{}.{}", v >> 22 & 127u, v >> 12 & 1023u, v & 4095u);
    return facts;  // left open: Vulkan is about to be used
}

std::vector<DeviceNode> examine_nodes() {
    std::vector<std::string> paths;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator("/dev/dri", error))
        if (entry.path().filename().string().starts_with("renderD"))
            paths.push_back(entry.path().string());
    for (const char* path : {"/dev/nvidiactl", "/dev/nvidia0", "/dev/dxg"})
        if (exists(path)) paths.emplace_back(path);
    std::vector<DeviceNode> nodes;
    for (const std::string& path : paths)
        nodes.push_back({path, ::access(path.c_str(), R_OK | W_OK) == 0});
    return nodes;
}

DenoiserFacts examine_denoiser() {
    DenoiserFacts facts;
    const Result<oidn::Library> library = oidn::load_library();
    if (!library) {
        facts.trouble = library.error().message;
        return facts;
    }
    facts.path = library->file.string();
    for (const oidn::PhysicalDevice& device : oidn::physical_devices(*library))
        facts.devices.push_back(fmt::format("{} ({})", type_name(device.type), device.name));
    const Result<Denoiser> denoiser = Denoiser::open(DenoiseDevice::fastest, 0);
    if (denoiser)
        facts.fastest = denoiser->description();
    else
        facts.trouble = denoiser.error().message;
    return facts;
}

}  // namespace

Machine examine_machine() {
    Machine m;
    m.cpu = {cpu_model(), cpu_threads(), cpu_instruction_set()};
    m.memory = memory_facts();
    m.in_container = looks_like_a_container();
    m.built_with_vulkan = built_with_vulkan();
    m.loader = examine_loader();
    m.manifests = find_manifests(process_environment);
    m.chosen_drivers = process_environment("VK_DRIVER_FILES");
    if (m.chosen_drivers.empty()) m.chosen_drivers = process_environment("VK_ICD_FILENAMES");
    m.added_drivers = drivers_to_add(m.manifests, process_environment);
    for (DriverManifest& manifest : m.manifests)
        manifest.trouble = manifest_trouble(manifest);
    m.nodes = examine_nodes();
    m.nvidia = examine_nvidia(process_environment,
                              std::any_of(m.manifests.begin(), m.manifests.end(), is_nvidia));
    add_hidden_drivers();
    Result<std::vector<VulkanDevice>> devices = list_vulkan_devices();
    if (devices)
        m.devices = std::move(*devices);
    else
        m.devices_trouble = devices.error().line();
    m.denoiser = examine_denoiser();
    return m;
}

}  // namespace hm::cli
