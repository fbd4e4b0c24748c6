// The layer itself: each intercepted call checks whether it must fail before it calls the next
// layer.
#include <volk.h>
#include <vulkan/vk_layer.h>

#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <sstream>

#include "trouble/calls.h"
#include "trouble/trouble.h"

namespace hm::trouble {
namespace {

enum class Kind { fails, loses, names };

struct Call {
    const char* name;
    Kind kind;
};

#define HM_ROW(name, kind) {#name, Kind::kind},
constexpr Call kCalls[] = {HM_TROUBLE_INSTANCE_CALLS(HM_ROW)
                               HM_TROUBLE_DEVICE_CALLS(HM_ROW){"vkCreateInstance", Kind::fails},
                           {"vkCreateDevice", Kind::loses}};
#undef HM_ROW

constexpr const char* kProperties = "vkGetPhysicalDeviceProperties2";

#define HM_INDEX(name, kind) index_##name,
enum Index : std::size_t {
    HM_TROUBLE_INSTANCE_CALLS(HM_INDEX) HM_TROUBLE_DEVICE_CALLS(HM_INDEX) index_vkCreateInstance,
    index_vkCreateDevice
};
#undef HM_INDEX

// The next layer, for all objects of one instance or one device. Resolved at creation: later
// the loader, if it is next, returns our functions.
struct Next {
    VkInstance instance = VK_NULL_HANDLE;
    PFN_vkGetInstanceProcAddr instance_function = nullptr;
    VkDevice device = VK_NULL_HANDLE;
    PFN_vkGetDeviceProcAddr device_function = nullptr;
    std::map<std::string, PFN_vkVoidFunction> found{};

    PFN_vkVoidFunction find(const char* name) const {
        return device != VK_NULL_HANDLE ? device_function(device, name)
                                        : instance_function(instance, name);
    }
    void find_all() {
        for (const Call& call : kCalls)
            found[call.name] = find(call.name);
        found[kProperties] = find(kProperties);
    }
    template <class F>
    F get(const char* name) const {
        return reinterpret_cast<F>(found.at(name));
    }
};

struct State {
    std::mutex mutex;
    std::map<void*, Next> chain;
    bool is_armed = false;
    VkResult result = VK_SUCCESS;
    std::uint32_t at = 0, counted = 0;
    std::string function;
    const Call* hit = nullptr;
    bool poses_as_card = false;
};

State& state() {
    static State s;
    return s;
}

// Objects of one instance or device share what the loader puts first into them.
template <class Handle>
void* key_of(Handle handle) {
    void* key = nullptr;
    std::memcpy(&key, reinterpret_cast<const void*>(handle), sizeof(key));
    return key;
}

bool waits(const Call& call) {
    return std::strcmp(call.name, "vkWaitSemaphores") == 0 ||
           std::strcmp(call.name, "vkDeviceWaitIdle") == 0;
}

// What the call must return instead of being made; VK_SUCCESS: it is made.
VkResult failure(const Call& call, const Next* next) {
    State& s = state();
    if (!s.is_armed) return VK_SUCCESS;
    const bool loses = s.result == VK_ERROR_DEVICE_LOST;
    if (loses && call.kind != Kind::loses) return VK_SUCCESS;
    if (s.hit != nullptr) return loses || (s.hit == &call && !waits(call)) ? s.result : VK_SUCCESS;
    if (s.function.empty() ? call.kind == Kind::names : s.function != call.name) return VK_SUCCESS;
    if (s.counted++ != s.at) return VK_SUCCESS;
    s.hit = &call;
    if (loses && next != nullptr) next->get<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(next->device);
    return s.result;
}

template <Index kIndex, class F>
struct Hook;
template <Index kIndex, class Handle, class... Rest>
struct Hook<kIndex, VkResult(VKAPI_PTR*)(Handle, Rest...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL call(Handle handle, Rest... rest) {
        using F = VkResult(VKAPI_PTR*)(Handle, Rest...);
        const Call& called = kCalls[kIndex];
        F next = nullptr;
        {
            const std::lock_guard lock(state().mutex);
            const Next& link = state().chain.at(key_of(handle));
            const VkResult failed = failure(called, &link);
            if (failed != VK_SUCCESS) return failed;
            next = link.get<F>(called.name);
        }
        return next(handle, rest...);
    }
};

// The loader's record in a create info's chain of where the next layer is.
template <class Info>
Info* link_info(const void* chain, VkStructureType type) {
    auto* info = const_cast<Info*>(static_cast<const Info*>(chain));
    while (info != nullptr && (info->sType != type || info->function != VK_LAYER_LINK_INFO))
        info = const_cast<Info*>(static_cast<const Info*>(info->pNext));
    return info;
}

// "VK_ERROR_DEVICE_LOST vkQueueSubmit2 3"
void arm_from_environment() {
    const char* text = std::getenv("HIMALAYA_TROUBLE");
    if (text == nullptr) return;
    std::istringstream words(text);
    std::string result, function;
    std::uint32_t at = 0;
    words >> result >> function >> at;
    arm(result == "VK_ERROR_DEVICE_LOST" ? VK_ERROR_DEVICE_LOST : VK_ERROR_OUT_OF_DEVICE_MEMORY, at,
        function);
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* allocator,
                                               VkInstance* instance) {
    auto* link = link_info<VkLayerInstanceCreateInfo>(
        info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    arm_from_environment();
    {
        const std::lock_guard lock(state().mutex);
        state().poses_as_card = std::getenv("HIMALAYA_TROUBLE_CARD") != nullptr;
        const VkResult failed = failure(kCalls[index_vkCreateInstance], nullptr);
        if (failed != VK_SUCCESS) return failed;
    }
    const auto create = reinterpret_cast<PFN_vkCreateInstance>(next(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, allocator, instance);
    if (result != VK_SUCCESS) return result;
    const std::lock_guard lock(state().mutex);
    Next& link_here = state().chain[key_of(*instance)];
    link_here = {*instance, next};
    link_here.find_all();
    return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical,
                                             const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator,
                                             VkDevice* device) {
    auto* link = link_info<VkLayerDeviceCreateInfo>(info->pNext,
                                                    VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    const PFN_vkGetDeviceProcAddr next = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    Next instance;
    {
        const std::lock_guard lock(state().mutex);
        instance = state().chain.at(key_of(physical));
        const VkResult failed = failure(kCalls[index_vkCreateDevice], nullptr);
        if (failed != VK_SUCCESS) return failed;
    }
    const VkResult result =
        instance.get<PFN_vkCreateDevice>("vkCreateDevice")(physical, info, allocator, device);
    if (result != VK_SUCCESS) return result;
    const std::lock_guard lock(state().mutex);
    Next& link_here = state().chain[key_of(*device)];
    link_here = {instance.instance, instance.instance_function, *device, next};
    link_here.find_all();
    return result;
}

// So that --device auto, which skips software devices, takes this one.
VKAPI_ATTR void VKAPI_CALL get_properties(VkPhysicalDevice physical,
                                          VkPhysicalDeviceProperties2* properties) {
    PFN_vkGetPhysicalDeviceProperties2 next = nullptr;
    {
        const std::lock_guard lock(state().mutex);
        next =
            state().chain.at(key_of(physical)).get<PFN_vkGetPhysicalDeviceProperties2>(kProperties);
    }
    next(physical, properties);
    if (state().poses_as_card)
        properties->properties.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
}

// Our function of this name, or nullptr.
PFN_vkVoidFunction hook_of(const std::string& name) {
    static const std::map<std::string, PFN_vkVoidFunction> kHooks = {
#define HM_HOOK(name, kind) \
    {#name, reinterpret_cast<PFN_vkVoidFunction>(&Hook<index_##name, PFN_##name>::call)},
        HM_TROUBLE_INSTANCE_CALLS(HM_HOOK) HM_TROUBLE_DEVICE_CALLS(HM_HOOK)
#undef HM_HOOK
            {"vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(&create_instance)},
        {"vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(&create_device)},
        {kProperties, reinterpret_cast<PFN_vkVoidFunction>(&get_properties)},
    };
    const auto found = kHooks.find(name);
    return found != kHooks.end() ? found->second : nullptr;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL device_function(VkDevice device, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&device_function);
    PFN_vkVoidFunction theirs = nullptr;
    {
        const std::lock_guard lock(state().mutex);
        theirs = state().chain.at(key_of(device)).find(name);
    }
    const PFN_vkVoidFunction ours = hook_of(name);
    return theirs != nullptr && ours != nullptr ? ours : theirs;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL instance_function(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetInstanceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&instance_function);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&device_function);
    const PFN_vkVoidFunction ours = hook_of(name);
    if (ours != nullptr || instance == VK_NULL_HANDLE) return ours;
    const std::lock_guard lock(state().mutex);
    return state().chain.at(key_of(instance)).find(name);
}

}  // namespace

void arm(VkResult result, std::uint32_t at, std::string_view function) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.is_armed = true;
    s.result = result;
    s.at = at;
    s.function = function;
    s.counted = 0;
    s.hit = nullptr;
}

void disarm() {
    const std::lock_guard lock(state().mutex);
    state().is_armed = false;
}

std::string hit() {
    const std::lock_guard lock(state().mutex);
    return state().hit != nullptr ? state().hit->name : "";
}

std::vector<std::string> functions() {
    std::vector<std::string> names;
    for (const Call& call : kCalls)
        names.emplace_back(call.name);
    return names;
}

}  // namespace hm::trouble

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* versions) {
    if (versions->sType != LAYER_NEGOTIATE_INTERFACE_STRUCT) return VK_ERROR_INITIALIZATION_FAILED;
    versions->loaderLayerInterfaceVersion = 2;
    versions->pfnGetInstanceProcAddr = hm::trouble::instance_function;
    versions->pfnGetDeviceProcAddr = hm::trouble::device_function;
    versions->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}
