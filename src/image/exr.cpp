// Reads OpenEXR files as environments, with the C++ interface of the OpenEXR library.
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

// The channels used as red, green and blue; a single one for grey pictures.
struct Colors {
    std::vector<std::string> channels;  // 3 or 1
    std::string layer;                  // empty: the unnamed layer
};

// R, G and B without a layer name, else Y, else R, G and B of the first layer that has them, else R
// alone.
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
    return refuse(name, fmt::format("no channels R, G and B or Y; found {}", list_of(first)),
                  ErrorKind::unsupported);
}

// The matrix to Rec. 709, or nullopt if the file is in Rec. 709.
Result<std::optional<Matrix3>> conversion_matrix(const Imf::Header& header, std::string_view name) {
    const Chromaticities stored = chromaticities_of(header);
    if (is_rec709(stored)) return std::optional<Matrix3>();
    std::optional<Matrix3> matrix = to_rec709(stored);
    if (!matrix) return refuse(name, "the chromaticities do not define a colour space");
    return matrix;
}

bool contains(const Imath::Box2i& outer, const Imath::Box2i& inner) {
    return outer.intersects(inner.min) && outer.intersects(inner.max);
}

// A black image of the display window. Limited relative to the data window, so that a small file
// cannot force a large allocation.
Result<FloatImage> black_display(const Imf::Header& header, std::string_view name) {
    constexpr std::uint64_t kAlwaysAllowed = 1u << 24, kMaxRatio = 64;
    const Imath::Box2i display = header.displayWindow(), data = header.dataWindow();
    const auto side = [](int min, int max) {
        return std::uint64_t(std::max<std::int64_t>(std::int64_t(max) - min + 1, 0));
    };
    const std::uint64_t width = side(display.min.x, display.max.x);
    const std::uint64_t height = side(display.min.y, display.max.y);
    HM_TRY(check_image_size(width, height, name));
    const std::uint64_t stored = side(data.min.x, data.max.x) * side(data.min.y, data.max.y);
    if (width * height > std::max(kAlwaysAllowed, stored * kMaxRatio))
        return refuse(name, fmt::format("the display window of {} x {} pixels has data for only {}",
                                        width, height, stored));
    FloatImage image{std::uint32_t(width), std::uint32_t(height)};
    for (Rgba<float>& pixel : image.pixels)
        pixel[3] = 1.0f;
    return image;
}

// Rows are read in blocks, so that a small file with a huge data window fails early.
constexpr std::size_t kBlockPixels = 1u << 20;

// Reads the rows of the data window and calls `row` with each.
template <class Row>
void read_rows(Imf::InputPart& part, const std::vector<std::string>& channels, const Row& row) {
    const Imath::Box2i data = part.header().dataWindow();
    const auto width = std::size_t(data.max.x - data.min.x + 1);
    const auto height = std::size_t(data.max.y - data.min.y + 1);
    const std::size_t block_rows =
        std::clamp(kBlockPixels / width, std::min<std::size_t>(16, height), height);
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
        return refuse(
            name, "cube maps are not supported; exrenvmap -l converts to a latitude-longitude map",
            ErrorKind::unsupported);
    for (const std::string& channel : chosen.colors.channels) {
        const Imf::Channel& c = header.channels()[channel];
        if (c.xSampling != 1 || c.ySampling != 1)
            return refuse(name, "channel " + channel + " is subsampled", ErrorKind::unsupported);
    }
    HM_TRY_ASSIGN(const std::optional<Matrix3> matrix, conversion_matrix(header, name));
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
        warnings.push_back(fmt::format(
            "EXR: no R, G and B without a layer name; reading layer \"{}\"", chosen.colors.layer));
    if (!contains(data, display))
        warnings.push_back(
            "EXR: the display window is larger than the data window; the rest is black");
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
