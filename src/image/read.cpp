#include "image/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <new>
#include <string>
#include <utility>

#include "image/codecs.h"

namespace hm {
namespace {

bool starts_with(Bytes bytes, std::initializer_list<unsigned> signature) {
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin(),
                      [](unsigned a, std::byte b) { return std::byte(a) == b; });
}

tl::unexpected<Error> refuse(std::string_view name, std::string message) {
    return fail(ErrorKind::invalid, std::string(name), "", std::move(message));
}

bool is_texture(FileFormat format) {
    return format == FileFormat::png || format == FileFormat::jpeg;
}

tl::unexpected<Error> refuse_format(std::string_view name, Bytes bytes) {
    return refuse(name, bytes.empty() ? "the image is empty" : "unknown image format");
}

template <class Decode>
auto within_memory(std::string_view name, const Decode& decode) -> decltype(decode()) {
    try {
        return decode();
    } catch (const std::bad_alloc&) {
        return refuse(name, "the image does not fit in memory");
    }
}

Result<TextureImage> decode_texture(FileFormat format, Bytes bytes, std::string_view name,
                                    ReadWarnings& warnings) {
    return within_memory(name, [&] {
        return format == FileFormat::png ? decode_png(bytes, name, warnings)
                                         : decode_jpeg(bytes, name);
    });
}

Result<FloatImage> decode_first_layer(Bytes bytes, std::string_view name) {
    HM_TRY_ASSIGN(const LayeredImage picture, decode_layers(bytes, name));
    return layer_image(picture, picture.layers.front());
}

}  // namespace

FileFormat file_format(Bytes bytes) {
    if (starts_with(bytes, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'})) return FileFormat::png;
    if (starts_with(bytes, {0xFF, 0xD8, 0xFF})) return FileFormat::jpeg;
    if (starts_with(bytes, {'#', '?'})) return FileFormat::hdr;
    if (starts_with(bytes, {0x76, 0x2F, 0x31, 0x01})) return FileFormat::exr;
    return FileFormat::unknown;
}

Result<void> check_image_size(std::uint64_t width, std::uint64_t height, std::string_view name) {
    if (width == 0 || height == 0) return refuse(name, "the image has no pixels");
    if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImagePixels)
        return refuse(name,
                      fmt::format("{} x {} pixels exceed the limit of {} per side or {} in total",
                                  width, height, kMaxImageSide, kMaxImagePixels));
    return {};
}

Result<TextureImage> read_texture_image(Bytes bytes, std::string_view name,
                                        ReadWarnings& warnings) {
    const FileFormat format = file_format(bytes);
    if (format == FileFormat::unknown) return refuse_format(name, bytes);
    if (!is_texture(format)) return refuse(name, "a texture must be PNG or JPEG");
    return decode_texture(format, bytes, name, warnings);
}

Result<FloatImage> read_environment_image(Bytes bytes, std::string_view name,
                                          ReadWarnings& warnings) {
    const FileFormat format = file_format(bytes);
    if (format == FileFormat::unknown) return refuse_format(name, bytes);
    if (is_texture(format)) return refuse(name, "an environment must be Radiance HDR or OpenEXR");
    return within_memory(name, [&] {
        return format == FileFormat::hdr ? decode_hdr(bytes, name, warnings)
                                         : decode_exr(bytes, name, warnings);
    });
}

Result<AnyImage> read_image(Bytes bytes, std::string_view name) {
    const FileFormat format = file_format(bytes);
    if (format == FileFormat::unknown) return refuse_format(name, bytes);
    ReadWarnings warnings;
    if (is_texture(format)) return decode_texture(format, bytes, name, warnings);
    if (format == FileFormat::hdr) return decode_hdr(bytes, name, warnings);
    return within_memory(name, [&] { return decode_first_layer(bytes, name); });
}

}  // namespace hm
