#include "image/picture_file.h"

#include <cstring>
#include <vector>

#include "base/files.h"
#include "image/codecs.h"
#include "image/read.h"

namespace hm {
namespace {

template <class Integer>
std::vector<float> over_black(const Image& image) {
    constexpr float kOne = float(Integer(~Integer(0)));
    std::vector<float> values(std::size_t(image.width) * image.height * 4);
    for (std::size_t i = 0; i < values.size(); i += 4) {
        Integer texel[4];
        std::memcpy(texel, &image.pixels[i * sizeof(Integer)], sizeof(texel));
        const float alpha = float(texel[3]) / kOne;
        for (std::size_t c = 0; c < 3; ++c)
            values[i + c] = float(texel[c]) / kOne * alpha;
        values[i + 3] = alpha;
    }
    return values;
}

}  // namespace

Result<PictureFile> read_picture_file(const std::filesystem::path& path) {
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(path));
    PictureFile file;
    if (file_format(bytes) == FileFormat::exr) {
        HM_TRY_ASSIGN(file.picture, decode_layers(bytes, path.string()));
        return file;
    }
    HM_TRY_ASSIGN(const Image image, read_image(bytes, path.string()));
    file.encoded = image.format != PixelFormat::rgba32f;
    file.picture.data = {0, 0, int(image.width), int(image.height)};
    file.picture.display = file.picture.data;
    if (!file.encoded) {
        file.picture.layers.push_back(make_layer("", image, false));
    } else {
        const std::vector<float> values = image.format == PixelFormat::rgba8
                                              ? over_black<std::uint8_t>(image)
                                              : over_black<std::uint16_t>(image);
        file.picture.layers.push_back(make_layer("", "RGBA", values));
    }
    return file;
}

}  // namespace hm
