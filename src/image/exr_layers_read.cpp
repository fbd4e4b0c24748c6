// Reads OpenEXR files as layers.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "image/codecs.h"
#include "image/exr_header.h"
#include "image/exr_layers.h"
#include "image/exr_stream.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(std::string_view name, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, std::string(name), "", "EXR: " + std::move(message));
}

PictureWindow window_of(const Imath::Box2i& box) {
    return {box.min.x, box.min.y, box.max.x + 1, box.max.y + 1};
}

// R G B A, X Y Z, U V u v, then the others by name.
std::size_t channel_rank(std::string_view name) {
    constexpr std::string_view kOrder = "RGBAXYZUVuv";
    return name.size() == 1 ? kOrder.find(name[0]) : std::string_view::npos;
}

Layer& find_or_add_layer(std::vector<Layer>& layers, std::string_view name) {
    for (Layer& layer : layers)
        if (layer.name == name) return layer;
    return layers.emplace_back(Layer{std::string(name), {}});
}

ChannelType type_of(Imf::PixelType type) {
    if (type == Imf::HALF) return ChannelType::half;
    return type == Imf::UINT ? ChannelType::uint32 : ChannelType::float32;
}

// A stored channel and its destination.
struct Incoming {
    std::string stored_name;
    std::size_t layer, channel;
};

// Adds a part's channels to the layers. If a channel of that name exists, as in files with one part
// per layer, the layer name is prefixed with the part's name.
Result<void> list_channels(const Imf::Header& header, std::string_view name,
                           std::vector<Layer>& layers, std::vector<Incoming>& incoming) {
    const Imf::ChannelList& list = header.channels();
    const auto taken = [&](const std::string& layer, const std::string& channel) {
        for (const Layer& l : layers)
            if (l.name == layer) return l.find(channel) != nullptr;
        return false;
    };
    for (auto c = list.begin(); c != list.end(); ++c) {
        const std::string full = c.name();
        if (c.channel().xSampling != 1 || c.channel().ySampling != 1)
            return refuse(name, "channel " + full + " is subsampled", ErrorKind::unsupported);
        const std::size_t dot = full.rfind('.');
        std::string layer = dot == full.npos ? "" : full.substr(0, dot);
        const std::string channel = dot == full.npos ? full : full.substr(dot + 1);
        if (taken(layer, channel)) layer = header.name() + (layer.empty() ? "" : "." + layer);
        if (taken(layer, channel)) return refuse(name, "duplicate channel " + full);
        Layer& target = find_or_add_layer(layers, layer);
        incoming.push_back({full, std::size_t(&target - layers.data()), target.channels.size()});
        target.channels.push_back({channel, {}, type_of(c.channel().type), {}});
    }
    return {};
}

void sort_channels(Layer& layer) {
    std::stable_sort(layer.channels.begin(), layer.channels.end(),
                     [](const LayerChannel& a, const LayerChannel& b) {
                         return channel_rank(a.name) < channel_rank(b.name);
                     });
}

// A block of rows of one channel.
struct Block {
    std::vector<float> floats;
    std::vector<std::uint32_t> integers;
};

void take_block(const Block& block, std::size_t count, LayerChannel& channel) {
    if (channel.type != ChannelType::uint32) {
        channel.values.insert(channel.values.end(), block.floats.begin(),
                              block.floats.begin() + std::ptrdiff_t(count));
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        channel.integers.push_back(block.integers[i]);
        channel.values.push_back(float(block.integers[i]));
    }
}

// Rows are read in blocks and memory grows with them, so that a small file with a huge data window
// fails early.
void read_rows(Imf::InputPart& part, const std::vector<Incoming>& channels, LayeredImage& picture) {
    constexpr std::size_t kBlockValues = 1u << 22;
    const std::size_t width = picture.data.width();
    const int rows = int(std::clamp<std::size_t>(
        kBlockValues / std::max<std::size_t>(width * channels.size(), 1), 1, 1024));
    std::vector<Block> blocks(channels.size());
    for (int first = picture.data.y0; first < picture.data.y1; first += rows) {
        const int last = std::min(first + rows, picture.data.y1) - 1;
        const Imath::Box2i window({picture.data.x0, first}, {picture.data.x1 - 1, last});
        const std::size_t count = width * std::size_t(last - first + 1);
        Imf::FrameBuffer frame;
        const auto channel_of = [&](std::size_t c) -> LayerChannel& {
            return picture.layers[channels[c].layer].channels[channels[c].channel];
        };
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const bool integers = channel_of(c).type == ChannelType::uint32;
            blocks[c].integers.resize(integers ? count : 0);
            blocks[c].floats.resize(integers ? 0 : count);
            const void* base = integers ? static_cast<const void*>(blocks[c].integers.data())
                                        : blocks[c].floats.data();
            frame.insert(
                channels[c].stored_name,
                Imf::Slice::Make(integers ? Imf::UINT : Imf::FLOAT, base, window, 4, 4 * width));
        }
        part.setFrameBuffer(frame);
        part.readPixels(first, last);
        for (std::size_t c = 0; c < channels.size(); ++c)
            take_block(blocks[c], count, channel_of(c));
    }
}

// Attributes of the first part: strings become metadata, the others are kept unchanged.
void read_attributes(const Imf::Header& header, LayeredImage& picture) {
    auto kept = std::make_shared<ExrAttributes>();
    for (auto a = header.begin(); a != header.end(); ++a) {
        if (describes_storage(a.name())) continue;
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
            picture.metadata.emplace_back(a.name(), text->value());
        else
            kept->header.insert(a.name(), a.attribute());
    }
    picture.attributes = std::move(kept);
    const Chromaticities stored = chromaticities_of(header);
    if (!is_rec709(stored)) picture.to_rec709 = to_rec709(stored);
}

Result<LayeredImage> read_file(Imf::MultiPartInputFile& file, std::string_view name) {
    LayeredImage picture;
    std::vector<std::vector<Incoming>> channels(std::size_t(file.parts()));
    for (int p = 0; p < file.parts(); ++p) {
        const Imf::Header& header = file.header(p);
        if (header.hasType() && !Imf::isImage(header.type()))
            return refuse(name, "deep data is not supported", ErrorKind::unsupported);
        const PictureWindow window = window_of(header.dataWindow());
        if (p == 0) picture.data = window;
        if (window != picture.data)
            return refuse(name, "parts with different data windows are not supported",
                          ErrorKind::unsupported);
        HM_TRY(list_channels(header, name, picture.layers, channels[std::size_t(p)]));
    }
    picture.display = window_of(file.header(0).displayWindow());
    for (int p = 0; p < file.parts(); ++p) {
        Imf::InputPart part(file, p);
        read_rows(part, channels[std::size_t(p)], picture);
    }
    for (Layer& layer : picture.layers)
        sort_channels(layer);
    read_attributes(file.header(0), picture);
    return picture;
}

}  // namespace

Result<LayeredImage> decode_layers(Bytes bytes, std::string_view name) {
    HM_TRY(check_exr_header(bytes, name));
    try {
        ExrInput stream(bytes, std::string(name));
        Imf::MultiPartInputFile file(stream);
        return read_file(file, name);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return refuse(name, error.what());
    }
}

}  // namespace hm
