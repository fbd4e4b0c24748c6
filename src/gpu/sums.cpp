#include "gpu/sums.h"

#include <cstddef>
#include <span>

#include "rhi/upload.h"

namespace hm {
namespace {

Result<rhi::Image> make_sum_image(rhi::Device& device, const char* name, rhi::Format format,
                                  std::uint32_t width, std::uint32_t height) {
    // Uploads leave images ready to be sampled.
    const rhi::ImageUse use = rhi::ImageUse::storage | rhi::ImageUse::sampled;
    return rhi::Image::create(device, {name, format, width, height, 1, use});
}

// Fills an image of layout general with the film's sums.
template <class T>
Result<void> upload(rhi::Device& device, const rhi::Image& image, const std::vector<T>& sums) {
    HM_TRY_ASSIGN(rhi::Uploader uploader, rhi::Uploader::create(device));
    HM_TRY(uploader.image(image, 0, std::as_bytes(std::span(sums))));
    HM_TRY(uploader.finish());
    return rhi::run_once(device, "sums to general", [&](rhi::Commands& commands) -> Result<void> {
        commands.transition(image, rhi::ImageLayout::shader_read, rhi::ImageLayout::general);
        return {};
    });
}

template <class T>
Result<std::vector<T>> download(rhi::Device& device, const rhi::Image& image, std::size_t count) {
    std::vector<T> sums(count);
    HM_TRY(rhi::read_back(device, image, rhi::ImageLayout::general,
                          std::as_writable_bytes(std::span(sums))));
    return sums;
}

}  // namespace

Result<GpuSums> GpuSums::create(rhi::Device& device, const Film& film, bool clamps) {
    const std::uint32_t width = film.crop.width();
    const std::uint32_t height = film.crop.height();
    GpuSums sums;
    sums.clamps_ = clamps;
    HM_TRY_ASSIGN(sums.accumulation_,
                  make_sum_image(device, "accumulation", rhi::Format::rgba32f, width, height));
    HM_TRY_ASSIGN(sums.removed_, make_sum_image(device, "removed luminance", rhi::Format::r32f,
                                                clamps ? width : 1, clamps ? height : 1));
    Values values;
    for (const PixelSum& s : film.sums) {
        values.radiance.emplace_back(s.radiance, s.alpha);
        values.removed.push_back(s.removed);
    }
    if (!clamps) values.removed.resize(1);
    HM_TRY(upload(device, sums.accumulation_, values.radiance));
    HM_TRY(upload(device, sums.removed_, values.removed));
    return sums;
}

Result<GpuSums::Values> GpuSums::download(rhi::Device& device) const {
    Values values;
    const std::size_t pixels =
        std::size_t(accumulation_.info().width) * accumulation_.info().height;
    HM_TRY_ASSIGN(values.radiance, hm::download<vec4>(device, accumulation_, pixels));
    if (clamps_) {
        HM_TRY_ASSIGN(values.removed, hm::download<float>(device, removed_, pixels));
    }
    return values;
}

}  // namespace hm
