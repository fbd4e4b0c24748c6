#include "gpu/layouts.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

#include "gpu/tables.h"

namespace hm {
namespace {

// An upper bound on the images of a scene.
constexpr std::uint32_t kMaxImages = 1u << 16;

constexpr std::uint32_t kTableNumbers[] = {
#define HM_TABLE(number, Type, name) number,
#include "shading/tables.inl"
};

constexpr bool counts_from_zero(std::span<const std::uint32_t> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (numbers[i] != i) return false;
    return true;
}
static_assert(counts_from_zero(kTableNumbers));

rhi::DescriptorKind kind_of(std::uint32_t binding) {
    if (binding == kFrameBinding) return rhi::DescriptorKind::uniform_buffer;
    if (binding == kStructureBinding) return rhi::DescriptorKind::acceleration_structure;
    return rhi::DescriptorKind::storage_buffer;
}

}  // namespace

Result<SceneLayouts> SceneLayouts::create(rhi::Device& device) {
    std::vector<rhi::Binding> scene;
    for (std::uint32_t b = 0; b < kFirstTableBinding + std::size(kTableNumbers); ++b)
        scene.push_back({b, kind_of(b)});
    const rhi::Binding images = {0, rhi::DescriptorKind::texture,
                                 std::min(kMaxImages, device.limits().max_textures), true};
    SceneLayouts layouts;
    HM_TRY_ASSIGN(layouts.scene, rhi::SetLayout::create(device, "scene", scene));
    HM_TRY_ASSIGN(layouts.textures,
                  rhi::SetLayout::create(device, "textures", std::span(&images, 1)));
    return layouts;
}

}  // namespace hm
