#include "gpu/textures.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace hm {
namespace {

rhi::Format format_of(const ImageView& image) {
    return image.format == std::uint32_t(PixelFormat::rgba8) ? rhi::Format::rgba8
                                                             : rhi::Format::rgba16;
}

std::uint64_t bytes_of(const ImageView& image) {
    return std::uint64_t(image.width) * image.height * bytes_per_pixel(PixelFormat(image.format));
}

// The images that materials read: all but occlusion, which is simulated.
std::vector<bool> used_images(const FlatScene& scene) {
    std::vector<bool> used(scene.images.size(), false);
    const auto use = [&](std::uint32_t texture, std::string_view slot) {
        if (slot != "occlusion_texture") used[scene.texture_uses[texture].image] = true;
    };
    for (const MaterialData& m : scene.materials) {
#define HM_TEXTURE(owner, key, slot, read, encoding, meaning) use(m.slot, #slot);
#define HM_EXTENDED_TEXTURE(...)
#include "shading/material/parameters.inl"
    }
    for (const ExtendedMaterialData& m : scene.extended_materials) {
#define HM_EXTENDED_TEXTURE(owner, key, slot, read, encoding, meaning) use(m.slot, #slot);
#include "shading/material/parameters.inl"
    }
    return used;
}

std::string name_of(std::size_t image) {
    return "image " + std::to_string(image);
}

// Before any image is uploaded.
Result<void> check_sides(const rhi::Device& device, const FlatScene& scene,
                         const std::vector<bool>& used) {
    const std::uint32_t most = device.limits().max_image_side;
    for (std::size_t i = 0; i < used.size(); ++i) {
        const ImageView& view = scene.images[i];
        if (used[i] && std::max(view.width, view.height) > most)
            return fail(ErrorKind::unsupported, "", "",
                        name_of(i) + " is " + std::to_string(view.width) + " x " +
                            std::to_string(view.height) + ", " + device.physical().name +
                            " supports up to " + std::to_string(most));
    }
    return {};
}

Result<rhi::Image> upload_image(rhi::Device& device, rhi::Uploader& uploader, const ImageView& view,
                                const std::string& name) {
    HM_TRY_ASSIGN(rhi::Image image,
                  rhi::Image::create(device, {name, format_of(view), view.width, view.height}));
    const auto* bytes = static_cast<const std::byte*>(view.pixels);
    HM_TRY(uploader.image(image, 0, {bytes, bytes_of(view)}));
    return image;
}

}  // namespace

std::uint64_t texture_bytes(const FlatScene& scene) {
    const std::vector<bool> used = used_images(scene);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) sum += bytes_of(scene.images[i]);
    return sum;
}

Result<GpuTextures> GpuTextures::upload(rhi::Device& device, rhi::Uploader& uploader,
                                        const rhi::SetLayout& layout, const FlatScene& scene) {
    const std::uint32_t room = layout.bindings()[0].count;
    if (scene.images.size() > room)
        return fail(ErrorKind::unsupported, "", "",
                    "the scene has " + std::to_string(scene.images.size()) + " images, " +
                        device.physical().name + " supports " + std::to_string(room));
    const std::vector<bool> used = used_images(scene);
    HM_TRY(check_sides(device, scene, used));
    GpuTextures out;
    // Shaders fetch texels and filter themselves; but the descriptors need a sampler.
    HM_TRY_ASSIGN(out.sampler_, rhi::Sampler::create(device, {"texel"}));
    HM_TRY_ASSIGN(out.set_, rhi::DescriptorSet::create(device, "textures", layout));
    out.images_.resize(scene.images.size());
    rhi::DescriptorWrites writes(layout);
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        HM_TRY_ASSIGN(out.images_[i], upload_image(device, uploader, scene.images[i], name_of(i)));
        writes.texture(0, out.images_[i], out.sampler_, std::uint32_t(i));
    }
    out.set_.update(writes);
    return out;
}

}  // namespace hm
