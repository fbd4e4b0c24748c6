#include "gpu/layouts.h"

#include <algorithm>
#include <vector>

namespace hm {
namespace {

// More images than any scene has.
constexpr std::uint32_t kMaxImages = 1u << 16;

rhi::DescriptorKind kind_of(SceneBinding binding) {
    if (binding == SceneBinding::frame) return rhi::DescriptorKind::uniform_buffer;
    if (binding == SceneBinding::structure) return rhi::DescriptorKind::acceleration_structure;
    return rhi::DescriptorKind::storage_buffer;
}

}  // namespace

Result<SceneLayouts> SceneLayouts::create(rhi::Device& device) {
    std::vector<rhi::Binding> scene;
    for (std::uint32_t b = 0; b < std::uint32_t(SceneBinding::count); ++b)
        scene.push_back({b, kind_of(SceneBinding(b))});
    const rhi::Binding images = {0, rhi::DescriptorKind::texture,
                                 std::min(kMaxImages, device.limits().max_textures), true};
    SceneLayouts layouts;
    HM_TRY_ASSIGN(layouts.scene, rhi::SetLayout::create(device, "scene", scene));
    HM_TRY_ASSIGN(layouts.textures,
                  rhi::SetLayout::create(device, "textures", std::span(&images, 1)));
    return layouts;
}

}  // namespace hm
