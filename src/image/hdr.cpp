// Radiance pictures (G. Ward, "Real Pixels", Graphics Gems II, 1991; Radiance's filefmts.pdf): a
// text header, then scan lines of shared-exponent pixels: flat, or run-length encoded in the old or
// the new format.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include "image/codecs.h"
#include "image/radiance.h"

namespace hm {
namespace {

using Rgbe = std::array<unsigned char, 4>;

// Widths for which new-style run-length encoding is defined.
constexpr std::uint32_t kMinRunWidth = 8;
constexpr std::uint32_t kMaxRunWidth = 32767;

struct Header {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::array<float, 3> scale = {1.0f, 1.0f, 1.0f};  // from stored values to radiance
    std::optional<Matrix3> to_rec709;                 // unset if the primaries are Rec. 709
};

// Consumes bytes from the front; fails past the end.
class Cursor {
  public:
    explicit Cursor(Bytes bytes) : rest_(bytes) {}

    std::size_t left() const { return rest_.size(); }
    std::optional<unsigned char> byte() {
        if (rest_.empty()) return std::nullopt;
        const auto first = std::to_integer<unsigned char>(rest_.front());
        rest_ = rest_.subspan(1);
        return first;
    }
    bool copy(void* to, std::size_t count) {
        if (count > rest_.size()) return false;
        std::memcpy(to, rest_.data(), count);
        rest_ = rest_.subspan(count);
        return true;
    }
    // The text up to the line feed, which is consumed too.
    std::optional<std::string_view> line() {
        const auto end = std::find(rest_.begin(), rest_.end(), std::byte('\n'));
        if (end == rest_.end()) return std::nullopt;
        const auto length = static_cast<std::size_t>(end - rest_.begin());
        std::string_view text(reinterpret_cast<const char*>(rest_.data()), length);
        rest_ = rest_.subspan(length + 1);
        if (text.ends_with('\r')) text.remove_suffix(1);
        return text;
    }

  private:
    Bytes rest_;
};

tl::unexpected<Error> refuse(std::string_view name, std::string location, std::string message,
                             ErrorKind kind = ErrorKind::invalid) {
    return fail(kind, std::string(name), std::move(location), "HDR: " + std::move(message));
}

// Consumes spaces and the next number of `text`.
template <class T>
std::optional<T> parse_number(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

// "-Y height +X width": rows from the top. The other seven orders are legal, but not used in
// practice.
Result<void> parse_resolution(std::string_view line, std::string_view name, Header& header) {
    const bool other_order = line.starts_with("+X") || line.starts_with("-X") ||
                             line.starts_with("+Y") || line.find("-X") != line.npos;
    if (other_order)
        return refuse(name, "", fmt::format("pixel order \"{}\" is not supported", line),
                      ErrorKind::unsupported);
    std::string_view rest = line;
    if (rest.starts_with("-Y ")) {
        rest.remove_prefix(3);
        const auto height = parse_number<std::uint32_t>(rest);
        if (height && rest.starts_with(" +X ")) {
            rest.remove_prefix(4);
            const auto width = parse_number<std::uint32_t>(rest);
            if (width && rest.find_first_not_of(' ') == rest.npos) {
                header.width = *width;
                header.height = *height;
                return {};
            }
        }
    }
    return refuse(name, "", fmt::format("\"{}\" is not a resolution", line.substr(0, 60)));
}

// Values are divided by all EXPOSURE and COLORCORR factors, which accumulate. Pixels are XYZ, or
// RGB with the given PRIMARIES, by default those of Rec. 709.
Result<void> parse_variable(std::string_view line, std::string_view name, Header& header) {
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return {};
    const std::string_view key = line.substr(0, equals);
    std::string_view value = line.substr(equals + 1);
    if (key == "FORMAT") {
        value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
        if (value.starts_with("32-bit_rle_xyze"))
            header.to_rec709 = to_rec709(kXyz);
        else if (!value.starts_with("32-bit_rle_rgbe"))
            return refuse(name, "",
                          fmt::format("format \"{}\" is not supported", value.substr(0, 60)),
                          ErrorKind::unsupported);
    } else if (key == "EXPOSURE" || key == "COLORCORR") {
        const bool per_channel = key == "COLORCORR";
        std::optional<float> factor;
        for (std::size_t c = 0; c < 3; ++c) {
            if (c == 0 || per_channel) factor = parse_number<float>(value);
            if (!factor || !std::isnormal(*factor) || *factor < 0.0f)
                return refuse(name, "", fmt::format("invalid {} in the header", key));
            header.scale[c] /= *factor;
        }
    } else if (key == "PRIMARIES") {
        std::array<double, 8> xy{};
        for (double& number : xy)
            number = parse_number<double>(value).value_or(std::nan(""));
        if (xy == std::array<double, 8>{}) return {};  // Photoshop writes zeros if unknown
        const Chromaticities primaries = {
            {xy[0], xy[1]}, {xy[2], xy[3]}, {xy[4], xy[5]}, {xy[6], xy[7]}};
        if (is_rec709(primaries)) return {};
        header.to_rec709 = to_rec709(primaries);
        if (!header.to_rec709)
            return refuse(name, "", fmt::format("invalid PRIMARIES \"{}\"", line.substr(0, 60)));
    }
    return {};
}

Result<Header> parse_header(Cursor& cursor, std::string_view name) {
    Header header;
    std::optional<std::string_view> line = cursor.line();  // the signature, known to be "#?..."
    for (line = cursor.line(); line && !line->empty(); line = cursor.line()) {
        if (!line->starts_with('#')) HM_TRY(parse_variable(*line, name, header));
    }
    if (line) line = cursor.line();
    if (!line) return refuse(name, "", "the header is truncated");
    HM_TRY(parse_resolution(*line, name, header));
    return header;
}

// New-style run-length encoding: each of the four components separately, as runs (count + 128,
// value) and literals. Returns an error message or null.
const char* read_component_runs(Cursor& cursor, std::span<Rgbe> row) {
    for (std::size_t component = 0; component < 4; ++component) {
        for (std::size_t x = 0; x < row.size();) {
            const auto code = cursor.byte();
            if (!code) return "is truncated";
            const bool run = *code > 128;
            const std::size_t count = run ? *code - 128u : *code;
            if (count == 0 || count > row.size() - x) return "has a run of invalid length";
            std::optional<unsigned char> value;
            for (std::size_t i = 0; i < count; ++i) {
                if (i == 0 || !run) value = cursor.byte();
                if (!value) return "is truncated";
                row[x++][component] = *value;
            }
        }
    }
    return nullptr;
}

// Flat pixels with old-style runs: (1, 1, 1, n) repeats the previous pixel n times; consecutive
// runs are the bytes of one count, least significant first. `first` is the pixel already read.
const char* read_pixels(Cursor& cursor, Rgbe first, std::span<Rgbe> row) {
    unsigned shift = 0;
    Rgbe pixel = first;
    for (std::size_t x = 0; x < row.size();) {
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            if (x == 0 || shift > 16) return "has a run without a pixel to repeat";
            const std::size_t count = std::size_t(pixel[3]) << shift;
            if (count > row.size() - x) return "has a run of invalid length";
            std::fill_n(row.begin() + std::ptrdiff_t(x), count, row[x - 1]);
            x += count;
            shift += 8;
        } else {
            row[x++] = pixel;
            shift = 0;
        }
        if (x < row.size() && !cursor.copy(pixel.data(), 4)) return "is truncated";
    }
    return nullptr;
}

const char* read_row(Cursor& cursor, std::span<Rgbe> row) {
    Rgbe first{};
    if (!cursor.copy(first.data(), 4)) return "is truncated";
    const bool may_run = row.size() >= kMinRunWidth && row.size() <= kMaxRunWidth;
    if (!may_run || first[0] != 2 || first[1] != 2 || first[2] >= 128)
        return read_pixels(cursor, first, row);
    if (row.size() != std::size_t(first[2]) * 256 + first[3]) return "has the wrong width";
    return read_component_runs(cursor, row);
}

// 2^(exponent - 136), as mantissas are in units of 1 / 256. Exponent 0 is black.
std::array<float, 256> exponent_table() {
    std::array<float, 256> table{};
    for (int e = 1; e < 256; ++e)
        table[std::size_t(e)] = std::ldexp(1.0f, e - 136);
    return table;
}

Rgbe to_rgbe(const Rgba<float>& rgb) {
    const float r = clean_radiance(rgb[0]), g = clean_radiance(rgb[1]), b = clean_radiance(rgb[2]);
    const float largest = std::max({r, g, b});
    if (largest == 0.0f) return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent);
    // 255.5 and above would round to 256, which requires the next exponent.
    if (std::ldexp(largest, 8 - exponent) >= 255.5f) ++exponent;
    if (exponent < -127) return {0, 0, 0, 0};
    exponent = std::min(exponent, 127);
    const auto mantissa = [&](float value) {
        const float scaled = std::floor(std::ldexp(value, 8 - exponent) + 0.5f);
        return static_cast<unsigned char>(std::min(scaled, 255.0f));
    };
    return {mantissa(r), mantissa(g), mantissa(b), static_cast<unsigned char>(exponent + 128)};
}

void append(std::vector<std::byte>& out, std::initializer_list<std::size_t> values) {
    for (const std::size_t value : values)
        out.push_back(std::byte(value));
}

// Runs shorter than 4 are stored as literals.
void append_component_runs(std::vector<std::byte>& out, std::span<const Rgbe> row,
                           std::size_t component) {
    const auto value = [&](std::size_t x) { return row[x][component]; };
    const auto run_length = [&](std::size_t x) {
        std::size_t end = x + 1;
        while (end < row.size() && end - x < 127 && value(end) == value(x))
            ++end;
        return end - x;
    };
    for (std::size_t x = 0; x < row.size();) {
        const std::size_t literal_begin = x;
        std::size_t run = run_length(x);
        while (run < 4 && x < row.size() && x - literal_begin + run <= 128) {
            x += run;
            run = x < row.size() ? run_length(x) : 0;
        }
        if (x > literal_begin) {
            append(out, {x - literal_begin});
            for (std::size_t i = literal_begin; i < x; ++i)
                append(out, {value(i)});
        }
        if (run >= 4) {
            append(out, {run + 128, value(x)});
            x += run;
        }
    }
}

}  // namespace

Result<FloatImage> decode_hdr(Bytes bytes, std::string_view name, ReadWarnings& warnings) {
    static const std::array<float, 256> kExponents = exponent_table();
    Cursor cursor(bytes);
    HM_TRY_ASSIGN(const Header header, parse_header(cursor, name));
    HM_TRY(check_image_size(header.width, header.height, name));
    // Every scan line has at least four bytes in any encoding.
    if (cursor.left() / 4 < header.height)
        return refuse(name, "",
                      fmt::format("{} bytes are too few for {} x {} pixels", cursor.left(),
                                  header.width, header.height));

    // Grows row by row, so that a truncated file does not commit memory for missing rows.
    FloatImage image;
    image.width = header.width;
    image.height = header.height;
    image.pixels.reserve(std::size_t(image.width) * image.height);
    RadianceReader radiance(header.to_rec709);
    std::vector<Rgbe> row(image.width);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        if (const char* wrong = read_row(cursor, row))
            return refuse(name, fmt::format("row {}", y), fmt::format("the scan line {}", wrong));
        for (const Rgbe& stored : row) {
            const auto value = [&](std::size_t c) {
                return float(stored[c]) * kExponents[stored[3]] * header.scale[c];
            };
            image.pixels.push_back(radiance.convert(value(0), value(1), value(2)));
        }
    }
    radiance.report("HDR", warnings);
    return image;
}

std::vector<std::byte> encode_hdr(const FloatImage& image) {
    const std::string header = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
                                           image.height, image.width);
    std::vector<std::byte> out;
    for (const char c : header)
        out.push_back(std::byte(c));
    std::vector<Rgbe> row(image.width);
    for (std::size_t y = 0; y < image.height; ++y) {
        for (std::size_t x = 0; x < row.size(); ++x)
            row[x] = to_rgbe(image.pixels[y * row.size() + x]);
        if (row.size() >= kMinRunWidth && row.size() <= kMaxRunWidth) {
            append(out, {2, 2, row.size() >> 8, row.size() & 255});
            for (std::size_t c = 0; c < 4; ++c)
                append_component_runs(out, row, c);
        } else {
            for (const Rgbe& pixel : row)
                append(out, {pixel[0], pixel[1], pixel[2], pixel[3]});
        }
    }
    return out;
}

}  // namespace hm
