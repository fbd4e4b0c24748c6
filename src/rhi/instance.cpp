#include "rhi/instance.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "base/text.h"
#include "rhi/error.h"

namespace hm::rhi {

namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

// Loads volk's global functions from this loader. The library stays open for the lifetime of the
// process, because drivers do not handle unloading well.
Result<void> open_loader(const std::string& path) {
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        const char* reason = dlerror();
        return fail(ErrorKind::no_device, "Vulkan", "",
                    fmt::format("no loader: {}; install the package libvulkan1 or your system's "
                                "equivalent",
                                reason != nullptr ? reason : path));
    }
    const auto entry =
        reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
    if (entry == nullptr)
        return fail(ErrorKind::no_device, "Vulkan", "", path + " is not a Vulkan loader");
    volkInitializeCustom(entry);
    if (vkEnumerateInstanceVersion == nullptr)
        return fail(ErrorKind::no_device, "Vulkan", "", path + " is older than Vulkan 1.1");
    return {};
}

bool has_layer(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    layers.resize(count);
    return std::ranges::any_of(layers, [name](const VkLayerProperties& layer) {
        return std::string_view(layer.layerName) == name;
    });
}

bool has_extension(const char* name) {
    std::uint32_t count = 0;
    vkEnumerateInstanceExtensionProperties(nullptr, &count, nullptr);
    std::vector<VkExtensionProperties> extensions(count);
    vkEnumerateInstanceExtensionProperties(nullptr, &count, extensions.data());
    extensions.resize(count);
    return std::ranges::any_of(extensions, [name](const VkExtensionProperties& extension) {
        return std::string_view(extension.extensionName) == name;
    });
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data,
                                          void* messages) {
    static_cast<Messages*>(messages)->add(
        {.error = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
         .id = data->pMessageIdName != nullptr ? data->pMessageIdName : "",
         .text = data->pMessage != nullptr ? data->pMessage : ""});
    return VK_FALSE;
}

// Only messages of the validation layer: general messages of drivers and the loader are about the
// machine, not the program.
VkDebugUtilsMessengerCreateInfoEXT messenger_info(Messages& messages) {
    return {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
            .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                               VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
            .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
            .pfnUserCallback = on_message,
            .pUserData = &messages};
}

}  // namespace

bool InstanceOptions::validation_wanted() {
    const char* value = std::getenv("HIMALAYA_VALIDATION");
    return value != nullptr && std::strcmp(value, "1") == 0;
}

Result<std::shared_ptr<Instance>> Instance::create(const InstanceOptions& options) {
    HM_TRY(open_loader(options.loader));
    if (options.validation && !has_layer(kValidationLayer))
        return fail(ErrorKind::no_device, "Vulkan", "",
                    fmt::format("validation is requested, but {} is not installed (package "
                                "vulkan-validationlayers)",
                                kValidationLayer));

    std::shared_ptr<Instance> made(new Instance);
    std::vector<const char*> extensions;
    if (has_extension(VK_EXT_DEBUG_UTILS_EXTENSION_NAME) || options.validation) {
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        made->names_objects_ = true;
    }
    if (options.validation) extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);

    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .pApplicationName = "himalaya",
                                        .apiVersion = VK_API_VERSION_1_3};
    const VkValidationFeatureEnableEXT enabled =
        VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info(made->messages_);
    const VkValidationFeaturesEXT validation{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                             .pNext = &messenger,
                                             .enabledValidationFeatureCount = 1,
                                             .pEnabledValidationFeatures = &enabled};
    const VkInstanceCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
        .pNext = options.validation ? &validation : nullptr,
        .pApplicationInfo = &application,
        .enabledLayerCount = options.validation ? 1u : 0u,
        .ppEnabledLayerNames = &kValidationLayer,
        .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
        .ppEnabledExtensionNames = extensions.data()};
    const VkResult result = vkCreateInstance(&info, nullptr, &made->instance_);
    // The loader reports this if it found no driver.
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        return fail(ErrorKind::no_device, "Vulkan", "", kNoDevices);
    HM_TRY(check(result, "vkCreateInstance", "the instance"));
    volkLoadInstance(made->instance_);
    if (options.validation) {
        messenger.pNext = nullptr;
        HM_TRY(check(
            vkCreateDebugUtilsMessengerEXT(made->instance_, &messenger, nullptr, &made->messenger_),
            "vkCreateDebugUtilsMessengerEXT", "the messenger"));
    }
    return made;
}

Instance::~Instance() {
    // Print messages that were not fetched.
    for (const Message& message : messages_.take())
        fmt::print(stderr, "himalaya: Vulkan validation: {}\n", printable(message.line()));
    if (messenger_ != VK_NULL_HANDLE)
        vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
    if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

Result<std::vector<PhysicalDevice>> Instance::devices() const {
    std::vector<VkPhysicalDevice> handles;
    VkResult result = VK_INCOMPLETE;
    while (result == VK_INCOMPLETE) {
        std::uint32_t count = 0;
        HM_TRY(check(vkEnumeratePhysicalDevices(instance_, &count, nullptr),
                     "vkEnumeratePhysicalDevices", "the devices"));
        handles.resize(count);
        result = vkEnumeratePhysicalDevices(instance_, &count, handles.data());
        HM_TRY(check(result, "vkEnumeratePhysicalDevices", "the devices"));
        handles.resize(count);
    }
    std::vector<PhysicalDevice> devices;
    for (const VkPhysicalDevice handle : handles) {
        HM_TRY_ASSIGN(PhysicalDevice device,
                      describe(handle, static_cast<std::uint32_t>(devices.size())));
        devices.push_back(std::move(device));
    }
    return devices;
}

}  // namespace hm::rhi
