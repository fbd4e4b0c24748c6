#include "output/write.h"

#include <string>

#include "base/check.h"

namespace hm {

namespace fs = std::filesystem;

std::optional<PictureKind> picture_kind(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    if (extension == ".exr") return PictureKind::exr;
    if (extension == ".png") return PictureKind::png;
    if (extension == ".hdr") return PictureKind::hdr;
    return std::nullopt;
}

Result<void> write_picture(const fs::path& path, const FloatImage& beauty,
                           const LayeredImage& layers, const PictureOptions& options) {
    const std::optional<PictureKind> kind = picture_kind(path);
    HM_CHECK(kind.has_value(), "{}", path.string());
    switch (*kind) {
        case PictureKind::exr:
            return write_layers(path, layers, options.exr);
        case PictureKind::png:
            return write_png(path, tone_map_picture(beauty, options.crop, options.tone),
                             options.alpha, layers.metadata);
        case PictureKind::hdr:
            break;
    }
    return write_hdr(path, beauty);
}

}  // namespace hm
