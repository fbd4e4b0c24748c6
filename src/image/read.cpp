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

Result<Image> decode(FileFormat format, Bytes bytes, std::string_view name, ExrValues values) {
    try {
        switch (format) {
            case FileFormat::png:
                return decode_png(bytes, name);
            case FileFormat::jpeg:
                return decode_jpeg(bytes, name);
            case FileFormat::hdr:
                return decode_hdr(bytes, name);
            case FileFormat::exr:
                return decode_exr(bytes, name, values);
            case FileFormat::unknown:
                break;
        }
    } catch (const std::bad_alloc&) {
        return refuse(name, "the picture does not fit in memory");
    }
    return refuse(name, bytes.empty() ? "the picture is empty" : "not a picture of a known format");
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
    if (width == 0 || height == 0) return refuse(name, "the picture has no pixels");
    if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImagePixels)
        return refuse(name, fmt::format("{} x {} pixels are more than {} a side or {} in all",
                                        width, height, kMaxImageSide, kMaxImagePixels));
    return {};
}

Result<Image> read_texture_image(Bytes bytes, std::string_view name) {
    const FileFormat format = file_format(bytes);
    if (format == FileFormat::hdr || format == FileFormat::exr)
        return refuse(name, "a texture has to be PNG or JPEG");
    return decode(format, bytes, name, ExrValues::cleaned);
}

Result<Image> read_environment_image(Bytes bytes, std::string_view name) {
    const FileFormat format = file_format(bytes);
    if (format == FileFormat::png || format == FileFormat::jpeg)
        return refuse(name, "an environment has to be Radiance HDR or OpenEXR");
    return decode(format, bytes, name, ExrValues::cleaned);
}

Result<Image> read_image(Bytes bytes, std::string_view name) {
    return decode(file_format(bytes), bytes, name, ExrValues::stored);
}

}  // namespace hm
