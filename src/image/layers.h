// A picture of several layers, as OpenEXR files hold it: channels called LAYER.CHANNEL, the picture
// proper R, G, B and A without a layer's name.
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

// How a channel is stored in the file; in memory all are floats. 32-bit integers, which files of
// others may hold, are kept beside them.
enum class ChannelType { float32, half, uint32 };

struct LayerChannel {
    std::string name;           // without the layer's: "R"
    std::vector<float> values;  // rows from the top
    ChannelType type = ChannelType::float32;
    std::vector<std::uint32_t> integers{};  // uint32 only; `values` are the nearest floats
};

struct Layer {
    std::string name;                    // empty: the picture proper; may contain dots
    std::vector<LayerChannel> channels;  // R, G, B, A before X, Y, Z before others

    const LayerChannel* find(std::string_view channel) const;
};

// Half-open, y downwards. The windows of files may begin at negative numbers.
struct PictureWindow {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::uint32_t width() const { return std::uint32_t(x1 - x0); }
    std::uint32_t height() const { return std::uint32_t(y1 - y0); }
    std::size_t pixels() const { return std::size_t(width()) * height(); }
    bool operator==(const PictureWindow&) const = default;
};

struct LayeredImage {
    PictureWindow data;     // what the channels cover
    PictureWindow display;  // the whole picture that it is a part of
    std::vector<Layer> layers;
    Metadata metadata;  // text attributes, in the file by name
    // Other attributes of the file that this was read from; write_layers writes them again. Without
    // them the chromaticities are Rec. 709's.
    std::shared_ptr<const ExrAttributes> attributes{};
    std::optional<Matrix3> to_rec709{};  // where the file's chromaticities are others

    const Layer* find(std::string_view layer) const;
    const std::string* find_metadata(std::string_view key) const;
};

// The first three channels as colour and "A" as alpha, 1 without one; a single channel is grey.
FloatImage layer_image(const LayeredImage& picture, const Layer& layer);

// Interleaved values of as many floats per pixel as `channels` has letters.
Layer make_layer(std::string name, std::string_view channels, std::span<const float> values);
// R, G, B and, with `alpha`, A.
Layer make_layer(std::string name, const FloatImage& image, bool alpha);

enum class ExrCompression { none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab };

// Whether float channels come back as they were. Other compressions are for the beauty, the layer
// without a name: the other layers are stored without loss, in a second part of the file.
constexpr bool is_lossless(ExrCompression compression) {
    return compression < ExrCompression::pxr24;
}

struct ExrOptions {
    ExrCompression compression = ExrCompression::zip;
    std::uint32_t tile = 0;  // side in pixels; 0: scan lines
};

// Finite values beyond what half can hold become its largest. No two channels have the same name.
Result<void> write_layers(const std::filesystem::path& path, const LayeredImage& picture,
                          const ExrOptions& options = {});

// Values as stored; parts are joined. Fails with ErrorKind::unreadable, invalid or unsupported
// (deep data, parts with different data windows, subsampled channels).
Result<LayeredImage> read_layers(const std::filesystem::path& path);

}  // namespace hm
