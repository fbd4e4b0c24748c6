// Descriptor set layouts, descriptor sets, and descriptor writes for sets and push descriptors.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "rhi/buffer.h"
#include "rhi/image.h"

namespace hm::rhi {

class AccelerationStructure;

enum class DescriptorKind {
    uniform_buffer,
    storage_buffer,
    storage_image,
    sampled_image,
    sampler,
    texture,  // combined image sampler
    acceleration_structure,
};

struct Binding {
    std::uint32_t binding = 0;
    DescriptorKind kind = DescriptorKind::storage_buffer;
    std::uint32_t count = 1;
    // Elements may stay unwritten, and may be written while the set is bound (but not in use).
    bool bindless = false;
};

// Visible to all stages.
class SetLayout {
  public:
    SetLayout() = default;
    // A layout for push descriptors has no bindless bindings.
    static Result<SetLayout> create(Device& device, std::string_view name,
                                    std::span<const Binding> bindings, bool push = false);
    std::span<const Binding> bindings() const { return bindings_; }
    bool push() const { return push_; }
    VkDescriptorSetLayout handle() const { return handle_.get(); }
    DescriptorKind kind_of(std::uint32_t binding) const;

  private:
    Handle<VkDescriptorSetLayout, &vkDestroyDescriptorSetLayout> handle_;
    std::vector<Binding> bindings_;
    bool push_ = false;
};

// A list of writes for DescriptorSet::update or Commands::push_set. The resources must be alive
// until then. Descriptor kinds are looked up in the layout, which must be the set's.
class DescriptorWrites {
  public:
    explicit DescriptorWrites(const SetLayout& layout) : layout_(&layout) {}

    DescriptorWrites& buffer(std::uint32_t binding, const Buffer& buffer, std::uint64_t offset = 0,
                             std::uint64_t size = VK_WHOLE_SIZE);
    // storage_image (layout general) or sampled_image (layout shader_read).
    DescriptorWrites& image(std::uint32_t binding, const Image& image, std::uint32_t element = 0);
    DescriptorWrites& sampler(std::uint32_t binding, const Sampler& sampler,
                              std::uint32_t element = 0);
    DescriptorWrites& texture(std::uint32_t binding, const Image& image, const Sampler& sampler,
                              std::uint32_t element = 0);
    DescriptorWrites& acceleration_structure(std::uint32_t binding,
                                             const AccelerationStructure& structure);

    // For push descriptors `set` is null. Valid until the next write is added.
    std::vector<VkWriteDescriptorSet> for_set(VkDescriptorSet set) const;

  private:
    VkWriteDescriptorSet& add(std::uint32_t binding, std::uint32_t element);

    const SetLayout* layout_;
    std::vector<VkWriteDescriptorSet> writes_;
    // Deques, because the writes point to their elements.
    std::deque<VkDescriptorBufferInfo> buffers_;
    std::deque<VkDescriptorImageInfo> images_;
    std::deque<VkAccelerationStructureKHR> structures_;
    std::deque<VkWriteDescriptorSetAccelerationStructureKHR> structure_writes_;
};

// A descriptor set with its own pool.
class DescriptorSet {
  public:
    DescriptorSet() = default;
    static Result<DescriptorSet> create(Device& device, std::string_view name,
                                        const SetLayout& layout);
    void update(const DescriptorWrites& writes);
    VkDescriptorSet handle() const { return handle_; }

  private:
    Device* device_ = nullptr;
    Handle<VkDescriptorPool, &vkDestroyDescriptorPool> pool_;
    VkDescriptorSet handle_ = VK_NULL_HANDLE;
};

}  // namespace hm::rhi
