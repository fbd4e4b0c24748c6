#include "image/layers.h"

#include <cstring>

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

Image layer_image(const LayeredImage& picture, const Layer& layer) {
    const LayerChannel* alpha = layer.find("A");
    std::vector<const LayerChannel*> colors;
    for (const LayerChannel& channel : layer.channels)
        if (&channel != alpha && colors.size() < 3) colors.push_back(&channel);
    if (colors.size() == 1) colors.resize(3, colors[0]);
    const std::size_t pixels = picture.data.pixels();
    std::vector<float> values(pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < colors.size(); ++c)
            values[4 * i + c] = colors[c]->values[i];
        values[4 * i + 3] = alpha ? alpha->values[i] : 1.0f;
    }
    const auto bytes = std::as_bytes(std::span(values));
    return {picture.data.width(),
            picture.data.height(),
            PixelFormat::rgba32f,
            {bytes.begin(), bytes.end()}};
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

Layer make_layer(std::string name, const Image& image, bool alpha) {
    HM_CHECK(image.format == PixelFormat::rgba32f, "format = {}", unsigned(image.format));
    std::vector<float> values(image.pixels.size() / sizeof(float));
    std::memcpy(values.data(), image.pixels.data(), image.pixels.size());
    Layer layer = make_layer(std::move(name), "RGBA", values);
    if (!alpha) layer.channels.pop_back();
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
