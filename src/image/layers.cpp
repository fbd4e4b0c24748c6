#include "image/layers.h"

#include <algorithm>
#include <iterator>

#include "base/check.h"
#include "base/files.h"
#include "image/codecs.h"

namespace hm {

const LayerChannel* Layer::find(std::string_view channel) const {
    for (const LayerChannel& c : channels)
        if (c.name == channel) return &c;
    return nullptr;
}

const Layer* LayeredImage::find(std::string_view layer) const {
    for (const Layer& l : layers)
        if (l.name == layer) return &l;
    return nullptr;
}

const std::string* LayeredImage::find_metadata(std::string_view key) const {
    for (const auto& [name, value] : metadata)
        if (name == key) return &value;
    return nullptr;
}

FloatImage layer_image(const LayeredImage& picture, const Layer& layer) {
    const LayerChannel* alpha = layer.find("A");
    std::vector<const LayerChannel*> colors;
    for (const LayerChannel& channel : layer.channels)
        if (&channel != alpha && colors.size() < 3) colors.push_back(&channel);
    if (colors.size() == 1) colors.resize(3, colors[0]);
    FloatImage image(picture.data.width(), picture.data.height());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (std::size_t c = 0; c < colors.size(); ++c)
            image.pixels[i][c] = colors[c]->values[i];
        image.pixels[i][3] = alpha ? alpha->values[i] : 1.0f;
    }
    return image;
}

Layer make_layer(std::string name, std::string_view channels, std::span<const float> values) {
    Layer layer{std::move(name), {}};
    const std::size_t count = channels.size();
    HM_CHECK(count > 0 && values.size() % count == 0, "{} values for {}", values.size(), channels);
    for (std::size_t c = 0; c < count; ++c) {
        LayerChannel& channel = layer.channels.emplace_back();
        channel.name.push_back(channels[c]);
        channel.values.reserve(values.size() / count);
        for (std::size_t i = c; i < values.size(); i += count)
            channel.values.push_back(values[i]);
    }
    return layer;
}

Layer make_layer(std::string name, const FloatImage& image, bool alpha) {
    Layer layer{std::move(name), {}};
    for (std::size_t c = 0; c < (alpha ? 4u : 3u); ++c) {
        LayerChannel& channel = layer.channels.emplace_back();
        channel.name = "RGBA"[c];
        channel.values.reserve(image.pixels.size());
        std::transform(image.pixels.begin(), image.pixels.end(), std::back_inserter(channel.values),
                       [c](const Rgba<float>& pixel) { return pixel[c]; });
    }
    return layer;
}

Result<void> write_layers(const std::filesystem::path& path, const LayeredImage& picture,
                          const ExrOptions& options) {
    auto encoded = encode_layers(picture, options);
    if (encoded) return write_file_atomically(path, *encoded);
    encoded.error().file = path.string();
    return tl::unexpected(std::move(encoded.error()));
}

Result<LayeredImage> read_layers(const std::filesystem::path& path) {
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(path));
    return decode_layers(bytes, path.string());
}

}  // namespace hm
