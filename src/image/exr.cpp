// Reads OpenEXR files as pictures of one layer, through the library's C++ interface.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <span>
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

// The library reads a channel once, so a grey one is copied to G and B here.
void finish_pixels(std::span<Rgba<float>> pixels, bool grey, bool cleaned) {
    for (Rgba<float>& pixel : pixels) {
        if (grey) pixel[1] = pixel[2] = pixel[0];
        if (!cleaned) continue;
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = clean_radiance(pixel[c]);
        pixel[3] = 1.0f;
    }
}

// Rows are read in blocks and memory is touched as they arrive: a small file that claims a large
// picture fails early.
constexpr std::uint32_t kPixelsAtOnce = 1u << 20;

Result<FloatImage> read_pixels(Imf::InputFile& file, std::string_view name, ExrValues values) {
    HM_TRY_ASSIGN(const ChannelNames channels, choose_channels(file.header().channels(), name));
    const bool grey = std::string_view(channels.names[0]) == "Y";
    const Imath::Box2i window = file.header().dataWindow();
    FloatImage image;
    image.width = std::uint32_t(window.max.x - window.min.x + 1);
    image.height = std::uint32_t(window.max.y - window.min.y + 1);
    const std::uint32_t block_rows =
        std::clamp(kPixelsAtOnce / image.width, std::min(16u, image.height), image.height);
    std::vector<Rgba<float>> block(std::size_t(image.width) * block_rows);
    image.pixels.reserve(std::size_t(image.width) * image.height);

    for (int first = window.min.y; first <= window.max.y; first += int(block_rows)) {
        const int last = std::min(first + int(block_rows) - 1, window.max.y);
        const Imath::Box2i part({window.min.x, first}, {window.max.x, last});
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < 4; ++c) {
            if (grey && (c == 1 || c == 2)) continue;
            // A channel that is not in the file is filled: alpha with one.
            const char* channel = channels.names[c] ? channels.names[c] : "A";
            frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, &block[0][c], part, sizeof(block[0]),
                                                   image.width * sizeof(block[0]), 1, 1, 1.0));
        }
        file.setFrameBuffer(frame);
        file.readPixels(first, last);
        const auto rows =
            std::span(block).first(std::size_t(image.width) * std::size_t(last - first + 1));
        finish_pixels(rows, grey, values == ExrValues::cleaned);
        image.pixels.insert(image.pixels.end(), rows.begin(), rows.end());
    }
    return image;
}

}  // namespace

Result<FloatImage> decode_exr(Bytes bytes, std::string_view name, ExrValues values) {
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

Result<std::vector<std::byte>> encode_exr(const FloatImage& image, bool alpha,
                                          const Metadata& metadata) {
    const PictureWindow window{0, 0, int(image.width), int(image.height)};
    return encode_layers({window, window, {make_layer("", image, alpha)}, metadata}, {});
}

}  // namespace hm
