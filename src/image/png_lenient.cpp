// Reads PNG files that Wuffs rejects with libspng. Like libpng and browsers, it discards ancillary
// chunks with a bad checksum and ignores data after the last row and after IEND. Bad checksums of
// critical chunks and missing rows are still errors.
#include <spng.h>

#include <fmt/format.h>

#include <memory>
#include <new>
#include <span>

#include "image/codecs.h"

namespace hm {
namespace {

struct FreeContext {
    void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

template <class T>
Result<ImageOf<T>> decode(spng_ctx* context, spng_format format) {
    const auto refuse = [](int error) {
        return fail(ErrorKind::invalid, "", "", fmt::format("PNG: {}", spng_strerror(error)));
    };
    spng_ihdr header;
    if (const int error = spng_get_ihdr(context, &header)) return refuse(error);
    ImageOf<T> image(header.width, header.height);
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(image.pixels));
    if (const int error =
            spng_decode_image(context, bytes.data(), bytes.size(), format, SPNG_DECODE_TRNS))
        return refuse(error);
    return image;
}

}  // namespace

Result<TextureImage> decode_png_leniently(Bytes bytes, bool sixteen_bits) {
    const std::unique_ptr<spng_ctx, FreeContext> context(spng_ctx_new(0));
    if (!context) throw std::bad_alloc();
    spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD);
    spng_set_image_limits(context.get(), kMaxImageSide, kMaxImageSide);
    spng_set_png_buffer(context.get(), bytes.data(), bytes.size());
    if (sixteen_bits) return decode<std::uint16_t>(context.get(), SPNG_FMT_RGBA16);
    return decode<std::uint8_t>(context.get(), SPNG_FMT_RGBA8);
}

}  // namespace hm
