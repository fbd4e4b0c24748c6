// Writes layers as OpenEXR files.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <ImfTiledOutputPart.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <new>
#include <utility>

#include "base/check.h"
#include "image/codecs.h"
#include "image/exr_layers.h"
#include "image/exr_stream.h"

namespace hm {
namespace {

constexpr std::array kCompressions = {
    Imf::NO_COMPRESSION,   Imf::RLE_COMPRESSION,   Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
    Imf::PIZ_COMPRESSION,  Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION,  Imf::B44A_COMPRESSION,
    Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION};

// Attribute names that OpenEXR readers interpret, whatever their type.
bool is_reserved(std::string_view name) {
    constexpr std::string_view kReserved[] = {"name",       "type",  "version", "view",
                                              "chunkCount", "tiles", "preview", "multiView"};
    return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
}

// Printable ASCII without spaces, at most 255 characters; underscores are appended until unused.
std::string attribute_name(const Imf::Header& header, std::string_view wanted) {
    constexpr std::size_t kMaxLength = 240;  // leaves room for the underscores
    std::string name;
    for (const char c : wanted.substr(0, kMaxLength))
        name += c > ' ' && c <= '~' ? c : '_';
    while (name.empty() || is_reserved(name) || header.find(name) != header.end())
        name += '_';
    return name;
}

Imath::Box2i box_of(const PictureWindow& w) {
    return {{w.x0, w.y0}, {w.x1 - 1, w.y1 - 1}};
}

// Finite values outside the range of half are clamped to it.
std::vector<half> to_half(std::span<const float> values) {
    constexpr float kLargest = 65504.0f;
    std::vector<half> halves(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        halves[i] =
            half(std::isfinite(values[i]) ? std::clamp(values[i], -kLargest, kLargest) : values[i]);
    return halves;
}

// A part to be written, and the memory that its frame buffer points into.
struct OutgoingPart {
    Imf::Header header;
    Imf::FrameBuffer frame;
    std::vector<std::vector<half>> halves;

    void add(const std::string& name, const LayerChannel& channel) {
        HM_CHECK(header.channels().findChannel(name) == nullptr, "duplicate channel {}", name);
        const Imath::Box2i box = header.dataWindow();
        const std::size_t width = std::size_t(box.max.x - box.min.x + 1);
        Imf::PixelType type = Imf::FLOAT;
        std::size_t size = sizeof(float);
        const void* base = channel.values.data();
        if (channel.type == ChannelType::half) {
            type = Imf::HALF;
            size = sizeof(half);
            base = halves.emplace_back(to_half(channel.values)).data();
        } else if (channel.type == ChannelType::uint32) {
            type = Imf::UINT;
            base = channel.integers.data();
        }
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::Slice::Make(type, base, box, size, width * size));
    }
};

Imf::Header make_header(const LayeredImage& picture, const ExrOptions& options) {
    Imf::Header header(box_of(picture.display), box_of(picture.data));
    header.compression() = kCompressions[std::size_t(options.compression)];
    if (options.tile != 0)
        header.setTileDescription(Imf::TileDescription(options.tile, options.tile));
    if (picture.attributes) {
        const Imf::Header& kept = picture.attributes->header;
        for (auto a = kept.begin(); a != kept.end(); ++a)
            if (!describes_storage(a.name())) header.insert(a.name(), a.attribute());
    } else {
        Imf::addChromaticities(header, Imf::Chromaticities());  // defaults to Rec. 709
    }
    return header;
}

// Lossy compression is applied to the beauty only: DWAA and DWAB treat every channel whose last
// component is R, G, B or Y as a colour, and B44 and PXR24 reduce the precision of floats. The
// other layers are then stored losslessly in a second part.
std::deque<OutgoingPart> make_parts(const LayeredImage& picture, const ExrOptions& options) {
    const bool split = !is_lossless(options.compression) &&
                       std::any_of(picture.layers.begin(), picture.layers.end(),
                                   [](const Layer& layer) { return !layer.name.empty(); });
    std::deque<OutgoingPart> parts;
    parts.push_back({make_header(picture, options), {}, {}});
    for (const auto& [key, value] : picture.metadata)
        parts[0].header.insert(attribute_name(parts[0].header, key), Imf::StringAttribute(value));
    if (split) {
        parts.push_back({make_header(picture, {ExrCompression::zip, options.tile}), {}, {}});
        parts[0].header.setName("beauty");
        parts[1].header.setName("data");
        for (OutgoingPart& part : parts)
            part.header.setType(options.tile != 0 ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
    }
    for (const Layer& layer : picture.layers)
        for (const LayerChannel& channel : layer.channels) {
            const std::size_t count = channel.type == ChannelType::uint32 ? channel.integers.size()
                                                                          : channel.values.size();
            HM_CHECK(count == picture.data.pixels(), "{}.{} has {} values", layer.name,
                     channel.name, count);
            parts[split && !layer.name.empty() ? 1 : 0].add(full_name(layer, channel), channel);
        }
    return parts;
}

template <class TiledFile>
void write_tiles(TiledFile&& file, const OutgoingPart& part) {
    file.setFrameBuffer(part.frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

template <class ScanLineFile>
void write_lines(ScanLineFile&& file, const OutgoingPart& part) {
    file.setFrameBuffer(part.frame);
    const Imath::Box2i box = part.header.dataWindow();
    file.writePixels(box.max.y - box.min.y + 1);
}

// The library writes offset tables when it closes a file.
void write_to(ExrOutput& stream, const std::deque<OutgoingPart>& parts) {
    const bool tiled = parts[0].header.hasTileDescription();
    if (parts.size() == 1) {
        if (tiled)
            write_tiles(Imf::TiledOutputFile(stream, parts[0].header), parts[0]);
        else
            write_lines(Imf::OutputFile(stream, parts[0].header), parts[0]);
        return;
    }
    std::vector<Imf::Header> headers;
    for (const OutgoingPart& part : parts)
        headers.push_back(part.header);
    Imf::MultiPartOutputFile file(stream, headers.data(), int(headers.size()));
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (tiled)
            write_tiles(Imf::TiledOutputPart(file, int(p)), parts[p]);
        else
            write_lines(Imf::OutputPart(file, int(p)), parts[p]);
    }
}

}  // namespace

Result<std::vector<std::byte>> encode_layers(const LayeredImage& picture,
                                             const ExrOptions& options) {
    HM_CHECK(picture.data.x0 < picture.data.x1 && picture.data.y0 < picture.data.y1,
             "{} layers without pixels", picture.layers.size());
    try {
        ExrOutput stream;
        write_to(stream, make_parts(picture, options));
        return std::move(stream.bytes);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return fail(ErrorKind::unwritable, "", "", std::string("EXR: ") + error.what());
    }
}

}  // namespace hm
