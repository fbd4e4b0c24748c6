// Layers to OpenEXR and back, through its library.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTiledOutputFile.h>
#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "base/check.h"
#include "image/codecs.h"
#include "image/exr_header.h"
#include "image/exr_stream.h"
#include "image/layers.h"

namespace hm {
namespace {

constexpr std::array kCompressions = {
    Imf::NO_COMPRESSION,   Imf::RLE_COMPRESSION,   Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
    Imf::PIZ_COMPRESSION,  Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION,  Imf::B44A_COMPRESSION,
    Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION};

// Attribute names that mean something to readers of OpenEXR, whatever their type.
bool is_reserved(std::string_view name) {
    constexpr std::string_view kReserved[] = {"name",       "type",  "version", "view",
                                              "chunkCount", "tiles", "preview", "multiView"};
    return std::find(std::begin(kReserved), std::end(kReserved), name) != std::end(kReserved);
}

// Printable ASCII without blanks, at most 255 characters; an underscore is added until it is free.
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

PictureWindow window_of(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

std::string full_name(const Layer& layer, const LayerChannel& channel) {
    return layer.name.empty() ? channel.name : layer.name + "." + channel.name;
}

// A value that half can't hold is the largest that it can, not infinity.
std::vector<half> to_half(std::span<const float> values) {
    constexpr float kLargest = 65504.0f;
    std::vector<half> halves(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        halves[i] = half(std::clamp(values[i], -kLargest, kLargest));
    return halves;
}

// The channels of a file being written, and the memory that its frame buffer points into.
struct Outgoing {
    Imf::FrameBuffer frame;
    std::vector<std::vector<half>> halves;

    void add(Imf::Header& header, const std::string& name, const LayerChannel& channel,
             const Imath::Box2i& box) {
        HM_CHECK(header.channels().findChannel(name) == nullptr, "two channels {}", name);
        const std::size_t width = std::size_t(box.max.x - box.min.x + 1);
        const bool is_half = channel.type == ChannelType::half;
        const Imf::PixelType type = is_half ? Imf::HALF : Imf::FLOAT;
        const std::size_t size = is_half ? sizeof(half) : sizeof(float);
        const void* base = channel.values.data();
        if (is_half) base = halves.emplace_back(to_half(channel.values)).data();
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::Slice::Make(type, base, box, size, width * size));
    }
};

void write_to(ExrOutput& stream, const Imf::Header& header, const Imf::FrameBuffer& frame) {
    if (header.hasTileDescription()) {
        Imf::TiledOutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        const Imath::Box2i box = header.dataWindow();
        file.writePixels(box.max.y - box.min.y + 1);
    }
}  // tables of offsets are written when the file is closed

tl::unexpected<Error> refuse(std::string_view name, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, std::string(name), "", "EXR: " + std::move(message));
}

// R G B A, X Y Z, U V u v, then the others by their names.
std::size_t channel_rank(std::string_view name) {
    constexpr std::string_view kOrder = "RGBAXYZUVuv";
    return name.size() == 1 ? kOrder.find(name[0]) : std::string_view::npos;
}

Layer& layer_called(std::vector<Layer>& layers, std::string_view name) {
    for (Layer& layer : layers)
        if (layer.name == name) return layer;
    return layers.emplace_back(Layer{std::string(name), {}});
}

// Where each of the file's channels goes, in its order.
struct Incoming {
    std::string full_name;
    std::size_t layer, channel;
};

Result<std::vector<Incoming>> list_channels(const Imf::ChannelList& list, std::string_view name,
                                            std::vector<Layer>& layers) {
    for (auto c = list.begin(); c != list.end(); ++c) {
        const std::string full = c.name();
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            return refuse(name, "channel " + full + " is subsampled", ErrorKind::unsupported);
        const std::size_t dot = full.rfind('.');
        const bool root = dot == full.npos;
        Layer& layer = layer_called(layers, root ? "" : full.substr(0, dot));
        layer.channels.push_back(
            {root ? full : full.substr(dot + 1),
             {},
             c.channel().type == Imf::HALF ? ChannelType::half : ChannelType::float32});
    }
    std::vector<Incoming> channels;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        std::stable_sort(layers[l].channels.begin(), layers[l].channels.end(),
                         [](const LayerChannel& a, const LayerChannel& b) {
                             return channel_rank(a.name) < channel_rank(b.name);
                         });
        for (std::size_t c = 0; c < layers[l].channels.size(); ++c)
            channels.push_back({full_name(layers[l], layers[l].channels[c]), l, c});
    }
    return channels;
}

// Rows are read in blocks and memory is touched as they come: a small file that claims a large
// picture fails before it has cost much.
void read_rows(Imf::InputFile& file, const std::vector<Incoming>& channels, LayeredImage& picture) {
    constexpr std::size_t kValuesAtOnce = 1u << 22;
    const std::size_t width = picture.data.width();
    const int rows = int(std::clamp<std::size_t>(
        kValuesAtOnce / std::max<std::size_t>(width * channels.size(), 1), 1, 1024));
    std::vector<std::vector<float>> blocks(channels.size(),
                                           std::vector<float>(width * std::size_t(rows)));
    for (int first = picture.data.y0; first < picture.data.y1; first += rows) {
        const int last = std::min(first + rows, picture.data.y1) - 1;
        const Imath::Box2i part({picture.data.x0, first}, {picture.data.x1 - 1, last});
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < channels.size(); ++c)
            frame.insert(channels[c].full_name,
                         Imf::Slice::Make(Imf::FLOAT, blocks[c].data(), part, sizeof(float),
                                          width * sizeof(float)));
        file.setFrameBuffer(frame);
        file.readPixels(first, last);
        const auto count = std::ptrdiff_t(width * std::size_t(last - first + 1));
        for (std::size_t c = 0; c < channels.size(); ++c) {
            auto& values = picture.layers[channels[c].layer].channels[channels[c].channel].values;
            values.insert(values.end(), blocks[c].begin(), blocks[c].begin() + count);
        }
    }
}

}  // namespace

Result<std::vector<std::byte>> encode_layers(const LayeredImage& picture,
                                             const ExrOptions& options) {
    HM_CHECK(picture.data.x0 < picture.data.x1 && picture.data.y0 < picture.data.y1,
             "{} layers without pixels", picture.layers.size());
    try {
        const Imath::Box2i box = box_of(picture.data);
        Imf::Header header(box_of(picture.display), box);
        header.compression() = kCompressions[std::size_t(options.compression)];
        if (options.tile != 0)
            header.setTileDescription(Imf::TileDescription(options.tile, options.tile));
        Imf::addChromaticities(header, Imf::Chromaticities());  // the default ones are Rec.709's
        Outgoing out;
        for (const Layer& layer : picture.layers)
            for (const LayerChannel& channel : layer.channels) {
                HM_CHECK(channel.values.size() == picture.data.pixels(), "{}.{} has {} values",
                         layer.name, channel.name, channel.values.size());
                out.add(header, full_name(layer, channel), channel, box);
            }
        for (const auto& [key, value] : picture.metadata)
            header.insert(attribute_name(header, key), Imf::StringAttribute(value));
        ExrOutput stream;
        write_to(stream, header, out.frame);
        return std::move(stream.bytes);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return fail(ErrorKind::unwritable, "", "", std::string("EXR: ") + error.what());
    }
}

Result<LayeredImage> decode_layers(Bytes bytes, std::string_view name) {
    HM_TRY(check_exr_header(bytes, name, ExrParts::one));
    try {
        ExrInput stream(bytes, std::string(name));
        Imf::InputFile file(stream);
        const Imf::Header& header = file.header();
        LayeredImage picture;
        picture.data = window_of(header.dataWindow());
        picture.display = window_of(header.displayWindow());
        HM_TRY_ASSIGN(const std::vector<Incoming> channels,
                      list_channels(header.channels(), name, picture.layers));
        read_rows(file, channels, picture);
        for (auto a = header.begin(); a != header.end(); ++a)
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
                picture.metadata.emplace_back(a.name(), text->value());
        return picture;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return refuse(name, error.what());
    }
}

}  // namespace hm
