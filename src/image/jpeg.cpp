// Reads JPEG with libjpeg-turbo. Its error callback leaves the library by longjmp, so all calls
// into it go through `guarded`, whose stack frames own no resources.
#include <fmt/format.h>

#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

#include <jpeglib.h>
// must follow jpeglib.h
#include <jerror.h>

#include "image/codecs.h"

namespace hm {
namespace {

// A progressive file may have any number of scans, each of which costs a pass over the whole
// picture; real files have about ten.
constexpr int kMaxScans = 200;

class Decoder {
  public:
    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { jpeg_destroy_decompress(&info_); }

    bool read_header(Bytes bytes);
    bool start(J_COLOR_SPACE space);
    bool read_row(Rgba<std::uint8_t>* row);
    bool finish();  // reads up to the end marker

    const jpeg_decompress_struct& info() const { return info_; }
    const char* message() const { return message_; }

  private:
    template <class Step>
    bool guarded(Step step) {
        if (setjmp(failed_) != 0) return false;
        step();
        return true;
    }

    [[noreturn]] static void on_error(j_common_ptr common);
    static void on_message(j_common_ptr common, int level);
    static void on_progress(j_common_ptr common);

    jpeg_decompress_struct info_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf failed_{};
    char message_[JMSG_LENGTH_MAX] = {};
};

void Decoder::on_error(j_common_ptr common) {
    auto* self = static_cast<Decoder*>(common->client_data);
    common->err->format_message(common, self->message_);
    std::longjmp(self->failed_, 1);
}

// If data is missing or damaged, libjpeg warns and continues with grey; here that is an error.
// Negative levels are warnings, others are trace messages.
void Decoder::on_message(j_common_ptr common, int level) {
    if (level >= 0) return;
    switch (common->err->msg_code) {
        case JWRN_ARITH_BAD_CODE:
        case JWRN_HIT_MARKER:
        case JWRN_HUFF_BAD_CODE:
        case JWRN_JPEG_EOF:
        case JWRN_MUST_RESYNC:
            on_error(common);
        default:
            break;  // stray bytes between markers, odd version numbers
    }
}

void Decoder::on_progress(j_common_ptr common) {
    auto* self = static_cast<Decoder*>(common->client_data);
    if (self->info_.input_scan_number <= kMaxScans) return;
    std::snprintf(self->message_, sizeof self->message_, "more than %d scans", kMaxScans);
    std::longjmp(self->failed_, 1);
}

bool Decoder::read_header(Bytes bytes) {
    info_.err = jpeg_std_error(&errors_);
    errors_.error_exit = on_error;
    errors_.emit_message = on_message;
    progress_.progress_monitor = on_progress;
    info_.client_data = this;
    return guarded([&] {
        jpeg_create_decompress(&info_);  // keeps err and client_data
        info_.progress = &progress_;
        jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(bytes.data()),
                     static_cast<unsigned long>(bytes.size()));
        jpeg_read_header(&info_, TRUE);
    });
}

bool Decoder::start(J_COLOR_SPACE space) {
    info_.out_color_space = space;
    return guarded([&] { jpeg_start_decompress(&info_); });
}

bool Decoder::read_row(Rgba<std::uint8_t>* row) {
    JSAMPLE* samples = row->data();
    return guarded([&] { jpeg_read_scanlines(&info_, &samples, 1); });
}

bool Decoder::finish() {
    return guarded([&] { jpeg_finish_decompress(&info_); });
}

// Converts in place. Adobe programs store inverted CMYK; their marker identifies such files.
void cmyk_to_rgba(std::span<Rgba<std::uint8_t>> pixels, bool inverted) {
    for (Rgba<std::uint8_t>& pixel : pixels) {
        const auto transmitted = [&](std::size_t c) {  // transmittance of the ink, 0..255
            return inverted ? unsigned(pixel[c]) : 255u - pixel[c];
        };
        const unsigned key = transmitted(3);
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = std::uint8_t((transmitted(c) * key + 127) / 255);
        pixel[3] = 255;
    }
}

tl::unexpected<Error> refuse(std::string_view name, std::string message) {
    return fail(ErrorKind::invalid, std::string(name), "", "JPEG: " + std::move(message));
}

}  // namespace

Result<TextureImage> decode_jpeg(Bytes bytes, std::string_view name) {
    Decoder decoder;
    if (!decoder.read_header(bytes)) return refuse(name, decoder.message());
    const jpeg_decompress_struct& info = decoder.info();
    HM_TRY(check_image_size(info.image_width, info.image_height, name));

    // Minimum size with Huffman coding: one bit for the DC value of every 8 x 8 block, with at most
    // 4 x 4 pixels per sample.
    const std::uint64_t pixels = std::uint64_t(info.image_width) * info.image_height;
    if (info.arith_code == FALSE && pixels / (8 * 64 * 16) > bytes.size())
        return refuse(name, fmt::format("{} bytes are too few for {} x {} pixels", bytes.size(),
                                        info.image_width, info.image_height));

    const J_COLOR_SPACE stored = info.jpeg_color_space;
    const bool cmyk = stored == JCS_CMYK || stored == JCS_YCCK;
    if (!cmyk && stored != JCS_GRAYSCALE && stored != JCS_YCbCr && stored != JCS_RGB)
        return refuse(name,
                      fmt::format("unknown colour space with {} components", info.num_components));
    if (!decoder.start(cmyk ? JCS_CMYK : JCS_EXT_RGBA)) return refuse(name, decoder.message());

    // Grows row by row, so that a truncated file does not commit memory for missing rows.
    Image8 image;
    image.width = info.image_width;
    image.height = info.image_height;
    image.pixels.reserve(pixels);
    for (std::size_t y = 0; y < image.height; ++y) {
        image.pixels.resize((y + 1) * image.width);
        if (!decoder.read_row(&image.pixels[y * image.width]))
            return refuse(name, decoder.message());
    }
    if (!decoder.finish()) return refuse(name, decoder.message());
    if (cmyk) cmyk_to_rgba(image.pixels, info.saw_Adobe_marker != FALSE);
    return image;
}

}  // namespace hm
