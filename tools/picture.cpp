#include "picture.h"

#include <spng.h>

#include <cstdlib>
#include <cstring>
#include <memory>

namespace hm {

Result<std::vector<std::byte>> encode_png(const std::string& name, const Picture& picture) {
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 spng_ctx_free);
    spng_ihdr header{};
    header.width = picture.width;
    header.height = picture.height;
    header.bit_depth = 8;
    header.color_type = std::uint8_t(picture.channels == 1   ? SPNG_COLOR_TYPE_GRAYSCALE
                                     : picture.channels == 3 ? SPNG_COLOR_TYPE_TRUECOLOR
                                                             : SPNG_COLOR_TYPE_TRUECOLOR_ALPHA);
    int error = context ? 0 : 1;
    if (!error) error = spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
    if (!error) error = spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 9);
    if (!error) error = spng_set_ihdr(context.get(), &header);
    if (!error)
        error = spng_encode_image(context.get(), picture.pixels.data(), picture.pixels.size(),
                                  SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
    std::size_t size = 0;
    void* data = error ? nullptr : spng_get_png_buffer(context.get(), &size, &error);
    if (error) return fail(ErrorKind::internal, name, "", spng_strerror(error));
    std::vector<std::byte> bytes(size);
    std::memcpy(bytes.data(), data, size);
    std::free(data);
    return bytes;
}

}  // namespace hm
