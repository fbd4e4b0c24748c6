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

// A tile may be larger than its picture, but not by much more than this.
constexpr std::uint64_t kMaxTileSide = 4096;

// 16 bytes of channel description follow each channel's name.
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

struct Claims {
    std::uint64_t width = 0, height = 0;
    std::uint64_t tile_width = 0, tile_height = 0;
    std::uint64_t channels = 0;  // at most
    std::uint64_t chunks = 0;
    std::uint64_t compression = 0;
};

// Codecs that OpenEXR 3.1 knows, and the names of those that later versions added.
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

// Names, each with 16 bytes behind it, ended by an empty one.
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

// Texts, each behind its length.
bool is_list_of_texts(Bytes value) {
    Cursor cursor(value);
    while (!cursor.at_end()) {
        const auto length = cursor.number();
        if (!length || !cursor.take(*length)) return false;
    }
    return true;
}

// Of the types that it knows, OpenEXR reads as many bytes as they have, whatever size the file
// gives. Where the two differ it would go on elsewhere than this check does, and see another
// header.
bool has_right_size(std::string_view type, Bytes value) {
    if (type == "chlist") return is_channel_list(value);
    if (type == "preview") return is_preview(value);
    if (type == "stringvector") return is_list_of_texts(value);
    if (type == "floatvector") return value.size() % 4 == 0;
    const auto* const known = std::find_if(kSizedTypes.begin(), kSizedTypes.end(),
                                           [&](const SizedType& t) { return t.name == type; });
    return known == kSizedTypes.end() || known->bytes == value.size();
}

void note_attribute(std::string_view attribute, std::string_view type, Bytes value,
                    Claims& claims) {
    Cursor cursor(value);
    if (attribute == "dataWindow" && type == "box2i" && value.size() == 16) {
        std::int64_t corner[4];  // x and y of the first pixel, then of the last one
        for (std::int64_t& c : corner)
            c = std::int32_t(*cursor.number());
        claims.width = std::uint64_t(std::max<std::int64_t>(corner[2] - corner[0] + 1, 0));
        claims.height = std::uint64_t(std::max<std::int64_t>(corner[3] - corner[1] + 1, 0));
    } else if (attribute == "tiles" && type == "tiledesc" && value.size() == 9) {
        claims.tile_width = *cursor.number();
        claims.tile_height = *cursor.number();
    } else if (attribute == "compression" && type == "compression") {
        claims.compression = std::to_integer<std::uint64_t>(value[0]);
    } else if (attribute == "chunkCount" && type == "int") {
        claims.chunks = *cursor.number();
    } else if (attribute == "channels" && type == "chlist") {
        claims.channels = value.size() / kMinChannelBytes;
    }
}

// The attributes of one part; nothing where the list of parts ends.
Result<std::optional<Claims>> read_header(Cursor& cursor, std::string_view name) {
    Claims claims;
    for (bool first = true;; first = false) {
        const auto attribute = cursor.word();
        if (!attribute) return refuse(name, "the header ends early");
        if (attribute->empty()) {
            if (first) return std::optional<Claims>();
            return std::optional(claims);
        }
        const auto type = cursor.word();
        const auto size = cursor.number();
        const auto value = size ? cursor.take(*size) : std::nullopt;
        if (!type || !value)
            return refuse(name, fmt::format("attribute \"{}\" ends past the file", *attribute));
        if (!has_right_size(*type, *value))
            return refuse(name, fmt::format("attribute \"{}\" of type \"{}\" has {} bytes",
                                            *attribute, *type, value->size()));
        note_attribute(*attribute, *type, *value, claims);
    }
}

struct Limits {
    std::uint64_t chunks;  // that the file has room for
    bool tiled;            // it may have tiles
};

Result<void> check_claims(const Claims& claims, const Limits& limits, std::string_view name) {
    if (claims.compression >= kCodecs)
        return refuse(name,
                      fmt::format("the codec {} is newer than the OpenEXR library here",
                                  codec_name(claims.compression)),
                      ErrorKind::unsupported);
    HM_TRY(check_image_size(claims.width, claims.height, name));
    const std::uint64_t side = std::max({claims.width, claims.height, kMaxTileSide});
    if (limits.tiled && (claims.tile_width > side || claims.tile_height > side ||
                         claims.tile_width * claims.tile_height > kMaxImagePixels))
        return refuse(name, fmt::format("tiles of {} x {} pixels are too large", claims.tile_width,
                                        claims.tile_height));
    if (claims.chunks > limits.chunks)
        return refuse(name, fmt::format("{} chunks are more than the file holds", claims.chunks));
    return {};
}

}  // namespace

Result<void> check_exr_header(Bytes bytes, std::string_view name) {
    Cursor cursor(bytes);
    const auto magic = cursor.number();
    const auto version = cursor.number();
    if (!magic || !version) return refuse(name, "the header ends early");
    const bool several = (*version & kMultiPartFlag) != 0;
    if ((*version & kDeepFlag) && !several)
        return refuse(name, "deep data is not supported", ErrorKind::unsupported);
    const Limits limits{bytes.size() / 8, (*version & kTiledFlag) != 0 || several};
    std::uint64_t values = 0;
    for (;;) {
        HM_TRY_ASSIGN(const std::optional<Claims> claims, read_header(cursor, name));
        if (!claims) break;
        HM_TRY(check_claims(*claims, limits, name));
        values += claims->width * claims->height * claims->channels;
        if (values > kMaxValues) return refuse(name, fmt::format("{} values are too many", values));
        if (!several) break;
    }
    return {};
}

}  // namespace hm
