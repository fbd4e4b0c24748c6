// Pictures of one layer from OpenEXR files, through the library's C++ interface.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include "image/codecs.h"
#include "image/exr_header.h"
#include "image/exr_stream.h"
#include "image/layers.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(std::string_view name, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, std::string(name), "", "EXR: " + std::move(message));
}

// Which stored channel fills each of R, G, B and A; null where there is none.
struct ChannelNames {
    const char* names[4] = {nullptr, nullptr, nullptr, nullptr};
};

Result<ChannelNames> choose_channels(const Imf::ChannelList& channels, std::string_view name) {
    const auto has = [&](const char* channel) { return channels.findChannel(channel) != nullptr; };
    const char* alpha = has("A") ? "A" : nullptr;
    if (has("R") && has("G") && has("B")) return ChannelNames{{"R", "G", "B", alpha}};
    if (has("RY") || has("BY"))
        return refuse(name, "luminance with chroma (Y, RY, BY) is not supported",
                      ErrorKind::unsupported);
    if (has("Y")) return ChannelNames{{"Y", "Y", "Y", alpha}};
    return refuse(name, "has neither channels R, G and B nor Y");
}

// A channel can be read into one place only: grey is spread over the other two here, and alpha is
// one where none was read. Values of lights are made finite and not negative.
void finish_pixels(std::span<float> rgba, bool grey, bool cleaned) {
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        if (grey) rgba[i + 1] = rgba[i + 2] = rgba[i];
        if (!cleaned) continue;
        for (std::size_t c = 0; c < 3; ++c)
            rgba[i + c] = clean_radiance(rgba[i + c]);
        rgba[i + 3] = 1.0f;
    }
}

// Rows are read in blocks and memory is touched as they come: a small file that claims a large
// picture fails before it has cost much.
constexpr std::uint32_t kPixelsAtOnce = 1u << 20;

Result<Image> read_pixels(Imf::InputFile& file, std::string_view name, ExrValues values) {
    HM_TRY_ASSIGN(const ChannelNames channels, choose_channels(file.header().channels(), name));
    const bool grey = std::string_view(channels.names[0]) == "Y";
    const Imath::Box2i window = file.header().dataWindow();
    Image image{std::uint32_t(window.max.x - window.min.x + 1),
                std::uint32_t(window.max.y - window.min.y + 1),
                PixelFormat::rgba32f,
                {}};
    const std::size_t row_floats = std::size_t(image.width) * 4;
    const std::uint32_t block_rows =
        std::clamp(kPixelsAtOnce / image.width, std::min(16u, image.height), image.height);
    std::vector<float> block(row_floats * block_rows);
    image.pixels.reserve(row_floats * sizeof(float) * image.height);

    for (int first = window.min.y; first <= window.max.y; first += int(block_rows)) {
        const int last = std::min(first + int(block_rows) - 1, window.max.y);
        const Imath::Box2i part({window.min.x, first}, {window.max.x, last});
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < 4; ++c) {
            if (grey && (c == 1 || c == 2)) continue;
            // A channel that is not in the file is filled: alpha with one.
            const char* channel = channels.names[c] ? channels.names[c] : "A";
            frame.insert(channel,
                         Imf::Slice::Make(Imf::FLOAT, block.data() + c, part, 4 * sizeof(float),
                                          row_floats * sizeof(float), 1, 1, 1.0));
        }
        file.setFrameBuffer(frame);
        file.readPixels(first, last);
        const auto rows = std::span(block).first(row_floats * std::size_t(last - first + 1));
        finish_pixels(rows, grey, values == ExrValues::cleaned);
        const auto bytes = std::as_bytes(rows);
        image.pixels.insert(image.pixels.end(), bytes.begin(), bytes.end());
    }
    return image;
}

}  // namespace

Result<Image> decode_exr(Bytes bytes, std::string_view name, ExrValues values) {
    HM_TRY(check_exr_header(bytes, name));
    try {
        ExrInput stream(bytes, std::string(name));
        Imf::InputFile file(stream);
        return read_pixels(file, name, values);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return refuse(name, error.what());
    }
}

Result<std::vector<std::byte>> encode_exr(const Image& image, bool alpha,
                                          const Metadata& metadata) {
    const PictureWindow window{0, 0, int(image.width), int(image.height)};
    return encode_layers({window, window, {make_layer("", image, alpha)}, metadata}, {});
}

}  // namespace hm
