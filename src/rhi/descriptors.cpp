#include "rhi/descriptors.h"

#include <algorithm>
#include <map>

#include "base/check.h"
#include "rhi/acceleration_structure.h"
#include "rhi/error.h"

namespace hm::rhi {

namespace {

VkDescriptorType type_of(DescriptorKind kind) {
    switch (kind) {
        case DescriptorKind::uniform_buffer:
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case DescriptorKind::storage_buffer:
            return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        case DescriptorKind::storage_image:
            return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
        case DescriptorKind::sampled_image:
            return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
        case DescriptorKind::sampler:
            return VK_DESCRIPTOR_TYPE_SAMPLER;
        case DescriptorKind::texture:
            return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        case DescriptorKind::acceleration_structure:
            break;
    }
    return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
}

bool is_sampled(DescriptorKind kind) {
    return kind == DescriptorKind::sampled_image || kind == DescriptorKind::sampler ||
           kind == DescriptorKind::texture;
}

}  // namespace

Result<SetLayout> SetLayout::create(Device& device, std::string_view name,
                                    std::span<const Binding> bindings, bool push) {
    std::vector<VkDescriptorSetLayoutBinding> list;
    std::vector<VkDescriptorBindingFlags> flags;
    VkDescriptorSetLayoutCreateFlags layout_flags =
        push ? VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR : 0;
    for (const Binding& binding : bindings) {
        // The required features allow this only for sampled images.
        HM_CHECK(!binding.bindless || (is_sampled(binding.kind) && !push), "{} binding {}", name,
                 binding.binding);
        list.push_back({.binding = binding.binding,
                        .descriptorType = type_of(binding.kind),
                        .descriptorCount = binding.count,
                        .stageFlags = VK_SHADER_STAGE_ALL});
        flags.push_back(binding.bindless ? VK_DESCRIPTOR_BINDING_PARTIALLY_BOUND_BIT |
                                               VK_DESCRIPTOR_BINDING_UPDATE_AFTER_BIND_BIT
                                         : 0);
        if (binding.bindless)
            layout_flags |= VK_DESCRIPTOR_SET_LAYOUT_CREATE_UPDATE_AFTER_BIND_POOL_BIT;
    }
    const VkDescriptorSetLayoutBindingFlagsCreateInfo flags_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_BINDING_FLAGS_CREATE_INFO,
        .bindingCount = static_cast<std::uint32_t>(flags.size()),
        .pBindingFlags = flags.data()};
    const VkDescriptorSetLayoutCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .pNext = &flags_info,
        .flags = layout_flags,
        .bindingCount = static_cast<std::uint32_t>(list.size()),
        .pBindings = list.data()};
    VkDescriptorSetLayout handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &handle),
                        "vkCreateDescriptorSetLayout", name));
    device.name(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, handle, name);
    SetLayout layout;
    layout.handle_ = {device.handle(), handle};
    layout.bindings_.assign(bindings.begin(), bindings.end());
    layout.push_ = push;
    return layout;
}

DescriptorKind SetLayout::kind_of(std::uint32_t binding) const {
    const auto found = std::ranges::find(bindings_, binding, &Binding::binding);
    HM_CHECK(found != bindings_.end(), "the layout has no binding {}", binding);
    return found->kind;
}

VkWriteDescriptorSet& DescriptorWrites::add(std::uint32_t binding, std::uint32_t element) {
    return writes_.emplace_back(
        VkWriteDescriptorSet{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                             .dstBinding = binding,
                             .dstArrayElement = element,
                             .descriptorCount = 1,
                             .descriptorType = type_of(layout_->kind_of(binding))});
}

DescriptorWrites& DescriptorWrites::buffer(std::uint32_t binding, const Buffer& buffer,
                                           std::uint64_t offset, std::uint64_t size) {
    add(binding, 0).pBufferInfo =
        &buffers_.emplace_back(VkDescriptorBufferInfo{buffer.handle(), offset, size});
    return *this;
}

DescriptorWrites& DescriptorWrites::image(std::uint32_t binding, const Image& image,
                                          std::uint32_t element) {
    const VkImageLayout layout = layout_->kind_of(binding) == DescriptorKind::storage_image
                                     ? VK_IMAGE_LAYOUT_GENERAL
                                     : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    add(binding, element).pImageInfo =
        &images_.emplace_back(VkDescriptorImageInfo{VK_NULL_HANDLE, image.view(), layout});
    return *this;
}

DescriptorWrites& DescriptorWrites::sampler(std::uint32_t binding, const Sampler& sampler,
                                            std::uint32_t element) {
    add(binding, element).pImageInfo = &images_.emplace_back(
        VkDescriptorImageInfo{sampler.handle(), VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED});
    return *this;
}

DescriptorWrites& DescriptorWrites::texture(std::uint32_t binding, const Image& image,
                                            const Sampler& sampler, std::uint32_t element) {
    add(binding, element).pImageInfo = &images_.emplace_back(VkDescriptorImageInfo{
        sampler.handle(), image.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    return *this;
}

DescriptorWrites& DescriptorWrites::acceleration_structure(std::uint32_t binding,
                                                           const AccelerationStructure& structure) {
    const VkAccelerationStructureKHR& handle = structures_.emplace_back(structure.handle());
    add(binding, 0).pNext =
        &structure_writes_.emplace_back(VkWriteDescriptorSetAccelerationStructureKHR{
            .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR,
            .accelerationStructureCount = 1,
            .pAccelerationStructures = &handle});
    return *this;
}

std::vector<VkWriteDescriptorSet> DescriptorWrites::for_set(VkDescriptorSet set) const {
    std::vector<VkWriteDescriptorSet> writes = writes_;
    for (VkWriteDescriptorSet& write : writes)
        write.dstSet = set;
    return writes;
}

Result<DescriptorSet> DescriptorSet::create(Device& device, std::string_view name,
                                            const SetLayout& layout) {
    std::map<VkDescriptorType, std::uint32_t> counts;
    bool bindless = false;
    for (const Binding& binding : layout.bindings()) {
        counts[type_of(binding.kind)] += binding.count;
        bindless = bindless || binding.bindless;
    }
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts)
        sizes.push_back({type, count});
    const VkDescriptorPoolCreateInfo pool_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
        .flags = bindless
                     ? VkDescriptorPoolCreateFlags{VK_DESCRIPTOR_POOL_CREATE_UPDATE_AFTER_BIND_BIT}
                     : 0,
        .maxSets = 1,
        .poolSizeCount = static_cast<std::uint32_t>(sizes.size()),
        .pPoolSizes = sizes.data()};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateDescriptorPool(device.handle(), &pool_info, nullptr, &pool),
                        "vkCreateDescriptorPool", name));
    DescriptorSet set;
    set.device_ = &device;
    set.pool_ = {device.handle(), pool};
    const VkDescriptorSetLayout layout_handle = layout.handle();
    const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .descriptorPool = pool,
                                           .descriptorSetCount = 1,
                                           .pSetLayouts = &layout_handle};
    HM_TRY(device.check(vkAllocateDescriptorSets(device.handle(), &info, &set.handle_),
                        "vkAllocateDescriptorSets", name));
    device.name(VK_OBJECT_TYPE_DESCRIPTOR_SET, set.handle_, name);
    return set;
}

void DescriptorSet::update(const DescriptorWrites& writes) {
    const std::vector<VkWriteDescriptorSet> list = writes.for_set(handle_);
    vkUpdateDescriptorSets(device_->handle(), static_cast<std::uint32_t>(list.size()), list.data(),
                           0, nullptr);
}

}  // namespace hm::rhi
