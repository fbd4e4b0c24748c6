#include "denoise/oidn_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <system_error>

namespace hm::oidn {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFileName = "libOpenImageDenoise.so.2";
constexpr const char* kHowToGet =
    "scripts/fetch-oidn.sh gets it; HIMALAYA_OIDN names its folder or file elsewhere";

tl::unexpected<Error> missing(const std::string& what) {
    return fail(ErrorKind::no_device, "", "",
                fmt::format("denoising needs Open Image Denoise 2: {}. {}", what, kHowToGet));
}

std::string loader_error() {
    const char* error = ::dlerror();
    return error != nullptr ? error : "no reason given";
}

// Files to try, each once, in order. In a folder the library may lie in lib/.
std::vector<fs::path> files_in(const fs::path& folder) {
    return {folder / kFileName, folder / "lib" / kFileName};
}

std::vector<fs::path> usual_files() {
    std::vector<fs::path> files;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        const fs::path here = program.parent_path();
        for (const fs::path& folder : {here, here / "../lib", here / "../lib/oidn"})
            for (const fs::path& file : files_in(folder))
                files.push_back(file.lexically_normal());
    }
    files.push_back(fs::path(HIMALAYA_BUILD_OIDN) / "lib" / kFileName);
    return files;
}

// The library looks for its core in $ORIGIN/../lib, which is only right in a folder of that name.
// What is loaded already it does not look for.
void load_core_beside(const fs::path& file) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path(), error))
        if (entry.path().filename().string().starts_with("libOpenImageDenoise_core.so."))
            ::dlopen(entry.path().c_str(), RTLD_NOW | RTLD_LOCAL);
}

template <class Function>
bool find(void* handle, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(handle, name));
    return function != nullptr;
}

// `file` with a folder is that file; without one, the loader looks among the system's libraries.
Result<Library> load(const fs::path& file) {
    if (file.has_parent_path()) load_core_beside(file);
    void* handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return missing(fmt::format("it does not load ({})", loader_error()));
    Library library{{}, file};
    const char* lacking = nullptr;
#define HM_OIDN(result, name, parameters) \
    if (!find(handle, "oidn" #name, library.api.name)) lacking = "oidn" #name;
    HM_OIDN_FUNCTIONS(HM_OIDN)
#undef HM_OIDN
    if (lacking != nullptr)
        return missing(fmt::format("{} is another version, without {}", file.string(), lacking));
    return library;
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

Result<Library> load_chosen(const fs::path& chosen) {
    if (is_file(chosen)) return load(chosen);
    for (const fs::path& file : files_in(chosen))
        if (is_file(file)) return load(file);
    return missing(fmt::format("HIMALAYA_OIDN is \"{}\", and {} is neither that nor in there",
                               chosen.string(), kFileName));
}

}  // namespace

Result<Library> load_library() {
    if (const char* chosen = std::getenv("HIMALAYA_OIDN"); chosen != nullptr && *chosen != '\0')
        return load_chosen(chosen);
    std::string looked;
    for (const fs::path& file : usual_files()) {
        if (is_file(file)) return load(file);
        looked += file.parent_path().string() + ", ";
    }
    Result<Library> system = load(kFileName);
    if (system) return system;
    return missing(
        fmt::format("{} is neither in {}nor among the system's libraries", kFileName, looked));
}

std::vector<PhysicalDevice> physical_devices(const Library& library) {
    std::vector<PhysicalDevice> devices;
    const int count = library.api.GetNumPhysicalDevices();
    for (int id = 0; id < count; ++id) {
        const char* name = library.api.GetPhysicalDeviceString(id, "name");
        devices.push_back({id, DeviceType(library.api.GetPhysicalDeviceInt(id, "type")),
                           name != nullptr ? name : "unnamed"});
    }
    return devices;
}

const char* type_name(DeviceType type) {
    switch (type) {
        case kCpu:
            return "cpu";
        case kSycl:
            return "sycl";
        case kCuda:
            return "cuda";
        case kHip:
            return "hip";
        case kMetal:
            return "metal";
        case kDefault:
            break;
    }
    return "unknown";
}

}  // namespace hm::oidn
