// OpenEXR files as environments, through the library's C++ interface.
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "image/codecs.h"
#include "image/exr_header.h"
#include "image/exr_layers.h"
#include "image/exr_stream.h"
#include "image/layers.h"
#include "image/radiance.h"

namespace hm {
namespace {

tl::unexpected<Error> refuse(std::string_view name, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, std::string(name), "", "EXR: " + std::move(message));
}

// The stored channels that are red, green and blue: one channel where the picture is grey.
struct Colors {
    std::vector<std::string> channels;  // 3 or 1
    std::string layer;                  // empty: the picture proper
};

// R, G and B of the picture proper, else its Y, else R, G and B of the first layer that has them,
// else R alone.
std::optional<Colors> choose_colors(const Imf::ChannelList& list) {
    const auto has = [&](const std::string& channel) {
        return list.findChannel(channel) != nullptr;
    };
    const auto rgb = [](const std::string& prefix) {
        return std::vector<std::string>{prefix + "R", prefix + "G", prefix + "B"};
    };
    const auto has_rgb = [&](const std::string& prefix) {
        return has(prefix + "R") && has(prefix + "G") && has(prefix + "B");
    };
    if (has_rgb("")) return Colors{rgb(""), ""};
    if (has("Y") && !has("RY") && !has("BY")) return Colors{{"Y"}, ""};
    for (auto c = list.begin(); c != list.end(); ++c) {
        const std::string channel = c.name();
        if (!channel.ends_with(".R")) continue;
        const std::string prefix = channel.substr(0, channel.size() - 1);
        if (has_rgb(prefix)) return Colors{rgb(prefix), prefix.substr(0, prefix.size() - 1)};
    }
    if (has("R") && !has("G") && !has("B")) return Colors{{"R"}, ""};
    return std::nullopt;
}

std::string list_of(const Imf::ChannelList& channels) {
    std::string list;
    for (auto c = channels.begin(); c != channels.end(); ++c)
        list += (list.empty() ? "" : ", ") + std::string(c.name());
    return list;
}

struct ChosenPart {
    int number = 0;
    Colors colors;
};

Result<ChosenPart> choose_part(Imf::MultiPartInputFile& file, std::string_view name) {
    for (int part = 0; part < file.parts(); ++part) {
        const Imf::Header& header = file.header(part);
        if (header.hasType() && !Imf::isImage(header.type())) continue;  // deep
        if (auto colors = choose_colors(header.channels())) return ChosenPart{part, *colors};
    }
    const Imf::ChannelList& first = file.header(0).channels();
    if (first.findChannel("RY") || first.findChannel("BY"))
        return refuse(name, "luminance with chroma (Y, RY, BY) is not supported",
                      ErrorKind::unsupported);
    return refuse(name, fmt::format("no R, G and B or Y among the channels {}", list_of(first)),
                  ErrorKind::unsupported);
}

// To Rec. 709, if the file's chromaticities are others.
Result<std::optional<Matrix3>> conversion(const Imf::Header& header, std::string_view name) {
    const Chromaticities stored = chromaticities_of(header);
    if (is_rec709(stored)) return std::optional<Matrix3>();
    std::optional<Matrix3> matrix = to_rec709(stored);
    if (!matrix) return refuse(name, "the chromaticities are no colour space");
    return matrix;
}

bool contains(const Imath::Box2i& outer, const Imath::Box2i& inner) {
    return outer.intersects(inner.min) && outer.intersects(inner.max);
}

// The display window, which a small file may claim to be large: then it takes memory for black.
Result<FloatImage> black_display(const Imf::Header& header, std::string_view name) {
    constexpr std::uint64_t kPixelsForAnyFile = 1u << 24, kTimesTheData = 64;
    const Imath::Box2i display = header.displayWindow(), data = header.dataWindow();
    const auto side = [](int min, int max) {
        return std::uint64_t(std::max<std::int64_t>(std::int64_t(max) - min + 1, 0));
    };
    const std::uint64_t width = side(display.min.x, display.max.x);
    const std::uint64_t height = side(display.min.y, display.max.y);
    HM_TRY(check_image_size(width, height, name));
    const std::uint64_t stored = side(data.min.x, data.max.x) * side(data.min.y, data.max.y);
    if (width * height > std::max(kPixelsForAnyFile, stored * kTimesTheData))
        return refuse(name, fmt::format("the display window of {} x {} pixels has data for {}",
                                        width, height, stored));
    FloatImage image{std::uint32_t(width), std::uint32_t(height)};
    for (Rgba<float>& pixel : image.pixels)
        pixel[3] = 1.0f;
    return image;
}

// Rows are read in blocks: a small file that claims a large data window fails early.
constexpr std::size_t kPixelsAtOnce = 1u << 20;

// Reads the data window's rows and hands those over that the display window shows.
template <class Row>
void read_rows(Imf::InputPart& part, const std::vector<std::string>& channels, const Row& row) {
    const Imath::Box2i data = part.header().dataWindow();
    const auto width = std::size_t(data.max.x - data.min.x + 1);
    const auto height = std::size_t(data.max.y - data.min.y + 1);
    const std::size_t block_rows =
        std::clamp(kPixelsAtOnce / width, std::min<std::size_t>(16, height), height);
    std::vector<std::array<float, 3>> block(width * block_rows);
    for (int first = data.min.y; first <= data.max.y; first += int(block_rows)) {
        const int last = std::min(first + int(block_rows) - 1, data.max.y);
        const Imath::Box2i rows({data.min.x, first}, {data.max.x, last});
        Imf::FrameBuffer frame;
        for (std::size_t c = 0; c < channels.size(); ++c)
            frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, &block[0][c], rows,
                                                       sizeof(block[0]), width * sizeof(block[0])));
        part.setFrameBuffer(frame);
        part.readPixels(first, last);
        for (int y = first; y <= last; ++y)
            row(y, &block[std::size_t(y - first) * width]);
    }
}

Result<FloatImage> read_part(Imf::MultiPartInputFile& file, const ChosenPart& chosen,
                             std::string_view name, ReadWarnings& warnings) {
    Imf::InputPart part(file, chosen.number);
    const Imf::Header& header = part.header();
    if (Imf::hasEnvmap(header) && Imf::envmap(header) == Imf::ENVMAP_CUBE)
        return refuse(name,
                      "cube maps are not supported; exrenvmap -l makes a latitude-longitude map",
                      ErrorKind::unsupported);
    for (const std::string& channel : chosen.colors.channels) {
        const Imf::Channel& c = header.channels()[channel];
        if (c.xSampling != 1 || c.ySampling != 1)
            return refuse(name, "channel " + channel + " is subsampled", ErrorKind::unsupported);
    }
    HM_TRY_ASSIGN(const std::optional<Matrix3> matrix, conversion(header, name));
    HM_TRY_ASSIGN(FloatImage image, black_display(header, name));
    const Imath::Box2i display = header.displayWindow(), data = header.dataWindow();
    RadianceReader radiance(matrix);
    const bool grey = chosen.colors.channels.size() == 1;
    const int x0 = std::max(data.min.x, display.min.x), x1 = std::min(data.max.x, display.max.x);
    read_rows(part, chosen.colors.channels, [&](int y, const std::array<float, 3>* row) {
        if (y < display.min.y || y > display.max.y) return;
        auto* out = &image.pixels[std::size_t(y - display.min.y) * image.width];
        for (int x = x0; x <= x1; ++x) {
            const std::array<float, 3>& rgb = row[x - data.min.x];
            out[x - display.min.x] = grey ? radiance.convert(rgb[0], rgb[0], rgb[0])
                                          : radiance.convert(rgb[0], rgb[1], rgb[2]);
        }
    });
    if (!chosen.colors.layer.empty())
        warnings.push_back(fmt::format("EXR: has no R, G and B proper; the layer \"{}\" is read",
                                       chosen.colors.layer));
    if (!contains(data, display))
        warnings.push_back("EXR: the display window is larger than the data window; black there");
    radiance.report("EXR", warnings);
    return image;
}

}  // namespace

Result<FloatImage> decode_exr(Bytes bytes, std::string_view name, ReadWarnings& warnings) {
    HM_TRY(check_exr_header(bytes, name));
    try {
        ExrInput stream(bytes, std::string(name));
        Imf::MultiPartInputFile file(stream);
        HM_TRY_ASSIGN(const ChosenPart chosen, choose_part(file, name));
        return read_part(file, chosen, name, warnings);
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
