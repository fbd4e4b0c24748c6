#include "image/write.h"

#include <cstddef>

#include "base/check.h"
#include "base/files.h"
#include "image/codecs.h"

namespace hm {
namespace {

template <class T>
void check_whole(const ImageOf<T>& image) {
    const std::size_t pixels = std::size_t(image.width) * image.height;
    HM_CHECK(pixels > 0 && image.pixels.size() == pixels, "{} x {}, {} pixels", image.width,
             image.height, image.pixels.size());
}

Result<void> write_encoded(const std::filesystem::path& path,
                           Result<std::vector<std::byte>> encoded) {
    if (encoded) return write_file_atomically(path, *encoded);
    encoded.error().file = path.string();
    return tl::unexpected(std::move(encoded.error()));
}

}  // namespace

Result<void> write_exr(const std::filesystem::path& path, const FloatImage& image, bool alpha,
                       const Metadata& metadata) {
    check_whole(image);
    return write_encoded(path, encode_exr(image, alpha, metadata));
}

Result<void> write_png(const std::filesystem::path& path, const Image8& image, bool alpha,
                       const Metadata& metadata) {
    check_whole(image);
    return write_encoded(path, encode_png(image, alpha, metadata));
}

Result<void> write_hdr(const std::filesystem::path& path, const FloatImage& image) {
    check_whole(image);
    return write_encoded(path, encode_hdr(image));
}

}  // namespace hm
