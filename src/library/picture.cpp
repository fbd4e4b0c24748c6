#include <fmt/format.h>
#include <himalaya/picture.h>

#include "library/errors.h"
#include "library/picture_impl.h"
#include "output/write.h"

namespace himalaya {

Picture::Picture(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Picture::Picture(Picture&&) noexcept = default;
Picture& Picture::operator=(Picture&&) noexcept = default;
Picture::~Picture() = default;

std::uint32_t Picture::width() const {
    return impl_->width;
}

std::uint32_t Picture::height() const {
    return impl_->height;
}

std::span<const float> Picture::pixels() const {
    return impl_->pixels;
}

std::vector<std::string> Picture::layer_names() const {
    std::vector<std::string> names;
    for (const hm::Layer& layer : impl_->finished.layers.layers)
        if (!layer.name.empty()) names.push_back(layer.name);
    return names;
}

Layer Picture::layer(const std::string& name) const {
    return guarded([&] {
        const hm::Layer* found = impl_->finished.layers.find(name);
        if (found == nullptr) refuse(fmt::format("the picture has no layer \"{}\"", name));
        Layer layer;
        const std::size_t channels = found->channels.size();
        layer.values.resize(channels * impl_->width * impl_->height);
        for (std::size_t c = 0; c < channels; ++c) {
            layer.channels.push_back(found->channels[c].name);
            for (std::size_t i = 0; i < found->channels[c].values.size(); ++i)
                layer.values[i * channels + c] = found->channels[c].values[i];
        }
        return layer;
    });
}

bool Picture::complete() const {
    return impl_->complete;
}

double Picture::samples_per_pixel() const {
    return impl_->samples_per_pixel;
}

const std::string& Picture::device() const {
    return impl_->device;
}

const std::vector<std::pair<std::string, std::string>>& Picture::metadata() const {
    return impl_->finished.layers.metadata;
}

const std::vector<std::string>& Picture::warnings() const {
    return impl_->warnings;
}

void Picture::write(const std::filesystem::path& path) const {
    guarded([&] {
        if (!hm::picture_kind(path))
            throw Error(ErrorKind::invalid_argument, "does not end in .exr, .png or .hdr",
                        path.string());
        value_or_throw(hm::write_picture(path, impl_->finished.picture, impl_->finished.layers,
                                         impl_->finished.options));
    });
}

}  // namespace himalaya
