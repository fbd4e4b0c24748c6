#include "gpu/compute.h"

#include <vulkan/vulkan.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace hm::test {

namespace {

constexpr const char* kNoDevice =
    "no usable Vulkan device. scripts/fetch-lavapipe.sh puts one that runs on the CPU into "
    "build/lavapipe, where ctest finds it; to run a test by hand, source build/lavapipe/env.sh "
    "first";

void check(VkResult result, const char* call) {
    if (result != VK_SUCCESS)
        throw std::runtime_error(std::string(call) + " returned VkResult " +
                                 std::to_string(result));
}

// Owns one object made from a device. Destroy is its vkDestroy* or vkFree* function.
template <class T, void (*Destroy)(VkDevice, T, const VkAllocationCallbacks*)>
class Owned {
  public:
    Owned(VkDevice device, T handle) : device_(device), handle_(handle) {}
    Owned(Owned&& other) noexcept
        : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
    Owned& operator=(Owned&&) = delete;
    ~Owned() { Destroy(device_, handle_, nullptr); }
    operator T() const { return handle_; }

  private:
    VkDevice device_;
    T handle_;
};

using Buffer = Owned<VkBuffer, vkDestroyBuffer>;
using Memory = Owned<VkDeviceMemory, vkFreeMemory>;
using ShaderModule = Owned<VkShaderModule, vkDestroyShaderModule>;
using SetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using PipelineLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using Pipeline = Owned<VkPipeline, vkDestroyPipeline>;
using DescriptorPool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using CommandPool = Owned<VkCommandPool, vkDestroyCommandPool>;

// Calls a vkCreate* function and owns what it made.
template <class Wrapper, class Handle, class Info>
Wrapper make(VkDevice device,
             VkResult (*create)(VkDevice, const Info*, const VkAllocationCallbacks*, Handle*),
             const Info& info, const char* call) {
    Handle handle = VK_NULL_HANDLE;
    check(create(device, &info, nullptr, &handle), call);
    return Wrapper(device, handle);
}

bool has_scalar_layout(VkPhysicalDevice device) {
    VkPhysicalDeviceVulkan12Features features12{};
    features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    VkPhysicalDeviceFeatures2 features{};
    features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    features.pNext = &features12;
    vkGetPhysicalDeviceFeatures2(device, &features);
    return features12.scalarBlockLayout == VK_TRUE;
}

VkPhysicalDeviceProperties properties_of(VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    return properties;
}

// Higher is better: a card before a processor's graphics before software; then the newer driver.
std::pair<int, std::uint32_t> preference(const VkPhysicalDeviceProperties& properties) {
    const int kind = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU     ? 3
                     : properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU ? 2
                     : properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU            ? 0
                                                                                       : 1;
    return {kind, properties.apiVersion};
}

VkPhysicalDevice choose_device(VkInstance instance) {
    std::uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance, &count, devices.data()),
          "vkEnumeratePhysicalDevices");
    std::erase_if(devices, [](VkPhysicalDevice device) {
        return properties_of(device).apiVersion < VK_API_VERSION_1_3 || !has_scalar_layout(device);
    });
    if (devices.empty()) throw std::runtime_error(kNoDevice);
    return *std::ranges::max_element(
        devices, {}, [](VkPhysicalDevice device) { return preference(properties_of(device)); });
}

std::uint32_t find_compute_family(VkPhysicalDevice device) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
    const auto found = std::ranges::find_if(families, [](const VkQueueFamilyProperties& family) {
        return (family.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0;
    });
    if (found == families.end()) throw std::runtime_error("the Vulkan device computes nothing");
    return static_cast<std::uint32_t>(found - families.begin());
}

}  // namespace

struct ComputeDevice::State {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    std::uint32_t family = 0;
    VkQueue queue = VK_NULL_HANDLE;
    std::string name;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (device != VK_NULL_HANDLE) vkDestroyDevice(device, nullptr);
        if (instance != VK_NULL_HANDLE) vkDestroyInstance(instance, nullptr);
    }

    void create_instance();
    void create_device();
    Buffer make_buffer(VkDeviceSize size) const;
    Memory bind_host_memory(VkBuffer buffer) const;
    void submit(VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set,
                std::uint32_t groups_x) const;
};

void ComputeDevice::State::create_instance() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_3;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    const VkResult result = vkCreateInstance(&info, nullptr, &instance);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) throw std::runtime_error(kNoDevice);
    check(result, "vkCreateInstance");
}

void ComputeDevice::State::create_device() {
    physical = choose_device(instance);
    family = find_compute_family(physical);
    name = properties_of(physical).deviceName;

    const float priority = 1;
    VkDeviceQueueCreateInfo queue_info{};
    queue_info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue_info.queueFamilyIndex = family;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    VkPhysicalDeviceVulkan12Features features12{};
    features12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    features12.scalarBlockLayout = VK_TRUE;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &features12;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue_info;
    check(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, family, 0, &queue);
}

Buffer ComputeDevice::State::make_buffer(VkDeviceSize size) const {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    return make<Buffer>(device, vkCreateBuffer, info, "vkCreateBuffer");
}

Memory ComputeDevice::State::bind_host_memory(VkBuffer buffer) const {
    constexpr VkMemoryPropertyFlags kWanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device, buffer, &needs);
    VkPhysicalDeviceMemoryProperties offered{};
    vkGetPhysicalDeviceMemoryProperties(physical, &offered);
    std::uint32_t type = 0;
    while (type < offered.memoryTypeCount &&
           ((needs.memoryTypeBits >> type & 1u) == 0 ||
            (offered.memoryTypes[type].propertyFlags & kWanted) != kWanted))
        ++type;
    if (type == offered.memoryTypeCount) throw std::runtime_error("no host-visible memory");

    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = type;
    Memory memory = make<Memory>(device, vkAllocateMemory, info, "vkAllocateMemory");
    check(vkBindBufferMemory(device, buffer, memory, 0), "vkBindBufferMemory");
    return memory;
}

void ComputeDevice::State::submit(VkPipeline pipeline, VkPipelineLayout layout, VkDescriptorSet set,
                                  std::uint32_t groups_x) const {
    VkCommandPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool_info.queueFamilyIndex = family;
    const CommandPool pool =
        make<CommandPool>(device, vkCreateCommandPool, pool_info, "vkCreateCommandPool");
    VkCommandBufferAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    allocate.commandPool = pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    check(vkAllocateCommandBuffers(device, &allocate, &commands), "vkAllocateCommandBuffers");

    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0,
                            nullptr);
    vkCmdDispatch(commands, groups_x, 1, 1);
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         0, 1, &barrier, 0, nullptr, 0, nullptr);
    check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");

    VkSubmitInfo submit_info{};
    submit_info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit_info.commandBufferCount = 1;
    submit_info.pCommandBuffers = &commands;
    check(vkQueueSubmit(queue, 1, &submit_info, VK_NULL_HANDLE), "vkQueueSubmit");
    check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
}

ComputeDevice::ComputeDevice() : state_(std::make_unique<State>()) {
    state_->create_instance();
    state_->create_device();
}
ComputeDevice::~ComputeDevice() = default;

const std::string& ComputeDevice::name() const {
    return state_->name;
}

namespace {

SetLayout make_set_layout(VkDevice device, std::uint32_t buffer_count) {
    std::vector<VkDescriptorSetLayoutBinding> bindings(buffer_count);
    for (std::uint32_t i = 0; i < buffer_count; ++i)
        bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT,
                       nullptr};
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = buffer_count;
    info.pBindings = bindings.data();
    return make<SetLayout>(device, vkCreateDescriptorSetLayout, info,
                           "vkCreateDescriptorSetLayout");
}

PipelineLayout make_pipeline_layout(VkDevice device, VkDescriptorSetLayout set_layout) {
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &set_layout;
    return make<PipelineLayout>(device, vkCreatePipelineLayout, info, "vkCreatePipelineLayout");
}

Pipeline make_pipeline(VkDevice device, std::span<const std::uint32_t> spirv,
                       VkPipelineLayout layout) {
    VkShaderModuleCreateInfo module_info{};
    module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module_info.codeSize = spirv.size_bytes();
    module_info.pCode = spirv.data();
    const ShaderModule module =
        make<ShaderModule>(device, vkCreateShaderModule, module_info, "vkCreateShaderModule");
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "vkCreateComputePipelines");
    return Pipeline(device, pipeline);
}

DescriptorPool make_pool(VkDevice device, std::uint32_t buffer_count) {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, buffer_count};
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = 1;
    info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    return make<DescriptorPool>(device, vkCreateDescriptorPool, info, "vkCreateDescriptorPool");
}

VkDescriptorSet make_set(VkDevice device, VkDescriptorPool pool, VkDescriptorSetLayout layout,
                         std::span<const Buffer> buffers) {
    VkDescriptorSetAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device, &allocate, &set), "vkAllocateDescriptorSets");
    for (std::uint32_t i = 0; i < buffers.size(); ++i) {
        const VkDescriptorBufferInfo range{buffers[i], 0, VK_WHOLE_SIZE};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set;
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        write.pBufferInfo = &range;
        vkUpdateDescriptorSets(device, 1, &write, 0, nullptr);
    }
    return set;
}

}  // namespace

struct ComputeShader::Parts {
    std::uint32_t buffer_count;
    SetLayout set_layout;
    PipelineLayout layout;
    Pipeline pipeline;

    Parts(VkDevice device, std::span<const std::uint32_t> spirv, std::uint32_t count)
        : buffer_count(count),
          set_layout(make_set_layout(device, count)),
          layout(make_pipeline_layout(device, set_layout)),
          pipeline(make_pipeline(device, spirv, layout)) {}
};

ComputeShader::ComputeShader(const ComputeDevice& device, std::span<const std::uint32_t> spirv,
                             std::uint32_t buffer_count)
    : device_(device),
      parts_(std::make_unique<Parts>(device.state_->device, spirv, buffer_count)) {}
ComputeShader::~ComputeShader() = default;

void ComputeShader::run(std::span<const std::span<std::byte>> buffers,
                        std::uint32_t groups_x) const {
    if (buffers.size() != parts_->buffer_count)
        throw std::runtime_error("the shader was made for another number of buffers");
    const ComputeDevice::State& state = *device_.state_;
    std::vector<Buffer> device_buffers;
    std::vector<Memory> memories;
    std::vector<void*> mapped;
    for (const std::span<std::byte> host : buffers) {
        device_buffers.push_back(state.make_buffer(host.size()));
        memories.push_back(state.bind_host_memory(device_buffers.back()));
        void* address = nullptr;
        check(vkMapMemory(state.device, memories.back(), 0, VK_WHOLE_SIZE, 0, &address),
              "vkMapMemory");
        mapped.push_back(address);
        std::memcpy(address, host.data(), host.size());
    }
    const DescriptorPool pool = make_pool(state.device, parts_->buffer_count);
    const VkDescriptorSet set = make_set(state.device, pool, parts_->set_layout, device_buffers);
    state.submit(parts_->pipeline, parts_->layout, set, groups_x);
    for (std::size_t i = 0; i < buffers.size(); ++i)
        std::memcpy(buffers[i].data(), mapped[i], buffers[i].size());
}

}  // namespace hm::test
