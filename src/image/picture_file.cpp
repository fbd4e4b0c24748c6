#include "image/picture_file.h"

#include <limits>
#include <utility>
#include <variant>

#include "base/files.h"
#include "image/codecs.h"
#include "image/read.h"

namespace hm {
namespace {

template <class Integer>
FloatImage over_black(const ImageOf<Integer>& image) {
    constexpr float kOne = float(std::numeric_limits<Integer>::max());
    FloatImage out(image.width, image.height);
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        const float alpha = float(image.pixels[i][3]) / kOne;
        for (std::size_t c = 0; c < 3; ++c)
            out.pixels[i][c] = float(image.pixels[i][c]) / kOne * alpha;
        out.pixels[i][3] = alpha;
    }
    return out;
}

}  // namespace

Result<PictureFile> read_picture_file(const std::filesystem::path& path) {
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(path));
    PictureFile file;
    const FileFormat format = file_format(bytes);
    if (format == FileFormat::exr) {
        HM_TRY_ASSIGN(file.picture, decode_layers(bytes, path.string()));
        return file;
    }
    FloatImage image;
    if (format == FileFormat::hdr) {
        HM_TRY_ASSIGN(image, read_environment_image(bytes, path.string(), file.warnings));
    } else {
        HM_TRY_ASSIGN(const TextureImage texture,
                      read_texture_image(bytes, path.string(), file.warnings));
        image = std::visit([](const auto& stored) { return over_black(stored); }, texture.image());
        file.encoded = true;
    }
    file.picture.data = {0, 0, int(image.width), int(image.height)};
    file.picture.display = file.picture.data;
    file.picture.layers.push_back(make_layer("", image, file.encoded));
    return file;
}

}  // namespace hm
