// The layout is that of "OpenEXR File Layout" (openexr.com): magic number, version and flags, then
// attributes (name, type, size, value), ended by an empty name. Numbers are little-endian.
#include "image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "image/read.h"

namespace hm {
namespace {

constexpr std::uint32_t kTiledFlag = 0x200, kDeepFlag = 0x800, kMultiPartFlag = 0x1000;
constexpr std::size_t kMaxNameLength = 255;

// A tile may be larger than the picture, but not larger than this.
constexpr std::uint64_t kMaxTileSide = 4096;

// Each channel is a name followed by 16 bytes.
constexpr std::uint64_t kMinChannelBytes = 18;
constexpr std::uint64_t kMaxValues = kMaxImagePixels * 16;

class Cursor {
  public:
    explicit Cursor(Bytes bytes) : rest_(bytes) {}

    std::optional<Bytes> take(std::size_t count) {
        if (count > rest_.size()) return std::nullopt;
        const Bytes taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }
    std::optional<std::uint32_t> number() {
        const auto four = take(4);
        if (!four) return std::nullopt;
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value |= std::to_integer<std::uint32_t>((*four)[i]) << (8 * i);
        return value;
    }
    // Zero-terminated.
    std::optional<std::string_view> word() {
        const std::size_t limit = std::min(rest_.size(), kMaxNameLength + 1);
        const Bytes range = rest_.first(limit);
        const auto end = std::find(range.begin(), range.end(), std::byte(0));
        if (end == range.end()) return std::nullopt;
        const auto length = static_cast<std::size_t>(end - range.begin());
        const std::string_view text(reinterpret_cast<const char*>(range.data()), length);
        rest_ = rest_.subspan(length + 1);
        return text;
    }

    bool at_end() const { return rest_.empty(); }

  private:
    Bytes rest_;
};

struct Declared {
    std::uint64_t width = 0, height = 0;
    std::uint64_t tile_width = 0, tile_height = 0;
    std::uint64_t channels = 0;  // at most
    std::uint64_t chunks = 0;
    std::uint64_t compression = 0;
};

// Number of codecs in OpenEXR 3.1, and the names of those added later.
constexpr std::uint64_t kCodecs = 10;
std::string codec_name(std::uint64_t codec) {
    constexpr std::string_view kLater[] = {"HTJ2K256", "HTJ2K32", "LJ2K", "ZSTD"};  // 3.4, 3.5
    if (codec < kCodecs + std::size(kLater)) return std::string(kLater[codec - kCodecs]);
    return fmt::format("number {}", codec);
}

tl::unexpected<Error> refuse(std::string_view name, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, std::string(name), "", "EXR: " + std::move(message));
}

struct SizedType {
    std::string_view name;
    std::size_t bytes;
};
constexpr std::array<SizedType, 24> kSizedTypes{{
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
}};

// Names followed by 16 bytes each; an empty name ends the list.
bool is_channel_list(Bytes value) {
    Cursor cursor(value);
    for (;;) {
        const auto channel = cursor.word();
        if (!channel) return false;
        if (channel->empty()) return cursor.at_end();
        if (!cursor.take(16)) return false;
    }
}

// Width, height and a picture of 4 bytes per pixel.
bool is_preview(Bytes value) {
    Cursor cursor(value);
    const auto width = cursor.number();
    const auto height = cursor.number();
    return width && height && (std::uint64_t{*width} * *height) == (value.size() - 8) / 4 &&
           value.size() % 4 == 0;
}

// Strings, each preceded by its length.
bool is_string_list(Bytes value) {
    Cursor cursor(value);
    while (!cursor.at_end()) {
        const auto length = cursor.number();
        if (!length || !cursor.take(*length)) return false;
    }
    return true;
}

// For the types that it knows, OpenEXR reads as many bytes as the type has, whatever size the file
// declares. If the two differ, it would continue at another position than this check and see
// another header.
bool has_right_size(std::string_view type, Bytes value) {
    if (type == "chlist") return is_channel_list(value);
    if (type == "preview") return is_preview(value);
    if (type == "stringvector") return is_string_list(value);
    if (type == "floatvector") return value.size() % 4 == 0;
    const auto* const known = std::find_if(kSizedTypes.begin(), kSizedTypes.end(),
                                           [&](const SizedType& t) { return t.name == type; });
    return known == kSizedTypes.end() || known->bytes == value.size();
}

void record_attribute(std::string_view attribute, std::string_view type, Bytes value,
                      Declared& declared) {
    Cursor cursor(value);
    if (attribute == "dataWindow" && type == "box2i" && value.size() == 16) {
        std::int64_t corner[4];  // x and y of the first pixel, then of the last one
        for (std::int64_t& c : corner)
            c = std::int32_t(*cursor.number());
        declared.width = std::uint64_t(std::max<std::int64_t>(corner[2] - corner[0] + 1, 0));
        declared.height = std::uint64_t(std::max<std::int64_t>(corner[3] - corner[1] + 1, 0));
    } else if (attribute == "tiles" && type == "tiledesc" && value.size() == 9) {
        declared.tile_width = *cursor.number();
        declared.tile_height = *cursor.number();
    } else if (attribute == "compression" && type == "compression") {
        declared.compression = std::to_integer<std::uint64_t>(value[0]);
    } else if (attribute == "chunkCount" && type == "int") {
        declared.chunks = *cursor.number();
    } else if (attribute == "channels" && type == "chlist") {
        declared.channels = value.size() / kMinChannelBytes;
    }
}

// The attributes of one part; nullopt at the end of the list of parts.
Result<std::optional<Declared>> read_header(Cursor& cursor, std::string_view name) {
    Declared declared;
    for (bool first = true;; first = false) {
        const auto attribute = cursor.word();
        if (!attribute) return refuse(name, "the header is truncated");
        if (attribute->empty()) {
            if (first) return std::optional<Declared>();
            return std::optional(declared);
        }
        const auto type = cursor.word();
        const auto size = cursor.number();
        const auto value = size ? cursor.take(*size) : std::nullopt;
        if (!type || !value)
            return refuse(
                name, fmt::format("attribute \"{}\" extends past the end of the file", *attribute));
        if (!has_right_size(*type, *value))
            return refuse(name, fmt::format("attribute \"{}\" of type \"{}\" has {} bytes",
                                            *attribute, *type, value->size()));
        record_attribute(*attribute, *type, *value, declared);
    }
}

struct Limits {
    std::uint64_t chunks;  // most chunks that fit into the file
    bool tiled;            // the file may have tiles
};

Result<void> check_declared(const Declared& declared, const Limits& limits, std::string_view name) {
    if (declared.compression >= kCodecs)
        return refuse(name,
                      fmt::format("compression {} requires a newer OpenEXR library",
                                  codec_name(declared.compression)),
                      ErrorKind::unsupported);
    HM_TRY(check_image_size(declared.width, declared.height, name));
    const std::uint64_t side = std::max({declared.width, declared.height, kMaxTileSide});
    if (limits.tiled && (declared.tile_width > side || declared.tile_height > side ||
                         declared.tile_width * declared.tile_height > kMaxImagePixels))
        return refuse(name, fmt::format("tiles of {} x {} pixels are too large",
                                        declared.tile_width, declared.tile_height));
    if (declared.chunks > limits.chunks)
        return refuse(name, fmt::format("{} chunks do not fit into the file", declared.chunks));
    return {};
}

}  // namespace

Result<void> check_exr_header(Bytes bytes, std::string_view name) {
    Cursor cursor(bytes);
    const auto magic = cursor.number();
    const auto version = cursor.number();
    if (!magic || !version) return refuse(name, "the header is truncated");
    const bool several = (*version & kMultiPartFlag) != 0;
    if ((*version & kDeepFlag) && !several)
        return refuse(name, "deep data is not supported", ErrorKind::unsupported);
    const Limits limits{bytes.size() / 8, (*version & kTiledFlag) != 0 || several};
    std::uint64_t values = 0;
    for (;;) {
        HM_TRY_ASSIGN(const std::optional<Declared> declared, read_header(cursor, name));
        if (!declared) break;
        HM_TRY(check_declared(*declared, limits, name));
        values += declared->width * declared->height * declared->channels;
        if (values > kMaxValues) return refuse(name, fmt::format("{} values are too many", values));
        if (!several) break;
    }
    return {};
}

}  // namespace hm
