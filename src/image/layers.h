// A picture with layers, as in OpenEXR files: channels are named LAYER.CHANNEL; R, G, B and A
// without a layer name are the beauty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "image/color_space.h"
#include "image/image.h"
#include "image/write.h"

namespace hm {

struct ExrAttributes;

// Storage type of a channel in the file; in memory all are floats. 32-bit integers, which files of
// other programs may have, are kept in addition.
enum class ChannelType { float32, half, uint32 };

struct LayerChannel {
    std::string name;           // without the layer name: "R"
    std::vector<float> values;  // rows from top to bottom
    ChannelType type = ChannelType::float32;
    std::vector<std::uint32_t> integers{};  // uint32 only; `values` are rounded to floats
};

struct Layer {
    std::string name;                    // empty: the beauty; may contain dots
    std::vector<LayerChannel> channels;  // ordered: R, G, B, A, then X, Y, Z, then others

    const LayerChannel* find(std::string_view channel) const;
};

// Half-open, y downwards. Coordinates may be negative.
struct PictureWindow {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::uint32_t width() const { return std::uint32_t(x1 - x0); }
    std::uint32_t height() const { return std::uint32_t(y1 - y0); }
    std::size_t pixels() const { return std::size_t(width()) * height(); }
    bool operator==(const PictureWindow&) const = default;
};

struct LayeredImage {
    PictureWindow data;     // the data window: what the channels cover
    PictureWindow display;  // the display window: the whole picture
    std::vector<Layer> layers;
    Metadata metadata;  // string attributes
    // Other attributes of the file that was read, written again by write_layers. If null, the file
    // gets the chromaticities of Rec. 709.
    std::shared_ptr<const ExrAttributes> attributes{};
    std::optional<Matrix3> to_rec709{};  // unset if the file is in Rec. 709

    const Layer* find(std::string_view layer) const;
    const std::string* find_metadata(std::string_view key) const;
};

// The first three channels as colour, and "A" as alpha (default 1); a single channel becomes grey.
FloatImage layer_image(const LayeredImage& picture, const Layer& layer);

// From interleaved values; each letter of `channels` is a channel.
Layer make_layer(std::string name, std::string_view channels, std::span<const float> values);
// R, G, B and, if `alpha`, A.
Layer make_layer(std::string name, const FloatImage& image, bool alpha);

enum class ExrCompression { none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab };

// Whether float channels are preserved exactly. Lossy compression applies to the beauty only; other
// layers are then stored losslessly in a second part of the file.
constexpr bool is_lossless(ExrCompression compression) {
    return compression < ExrCompression::pxr24;
}

struct ExrOptions {
    ExrCompression compression = ExrCompression::zip;
    std::uint32_t tile = 0;  // size in pixels; 0: scan lines
};

// Finite values outside the range of half are clamped. Channel names must be unique.
Result<void> write_layers(const std::filesystem::path& path, const LayeredImage& picture,
                          const ExrOptions& options = {});

// Values as stored; all parts are merged. Fails with ErrorKind::unreadable, invalid or unsupported
// (deep data, parts with different data windows, subsampled channels).
Result<LayeredImage> read_layers(const std::filesystem::path& path);

}  // namespace hm
