#include "film/write.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "base/check.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> unwritable(const fs::path& path, const std::string& why) {
    return fail(ExitCode::unwritable, path.string(), "", "can't be written: " + why);
}

}  // namespace

std::optional<PictureKind> picture_kind(const fs::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    if (extension == ".exr") return PictureKind::exr;
    if (extension == ".png") return PictureKind::png;
    if (extension == ".hdr") return PictureKind::hdr;
    return std::nullopt;
}

Result<void> check_writable(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) return unwritable(path, "it is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return unwritable(path, "it exists and is not a regular file");
    fs::path folder = path.parent_path();
    if (folder.empty()) folder = ".";
    if (!fs::is_directory(folder, error)) return unwritable(path, "there is no such folder");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return unwritable(path, std::generic_category().message(errno));
    return {};
}

Result<void> write_picture(const fs::path& path, const Image& linear, const PictureOptions& options,
                           const Metadata& metadata) {
    const std::optional<PictureKind> kind = picture_kind(path);
    HM_CHECK(kind.has_value(), "{}", path.string());
    switch (*kind) {
        case PictureKind::exr:
            return write_exr(path, linear, options.alpha, metadata);
        case PictureKind::png:
            return write_png(path, tone_map_picture(linear, options.crop, options.tone),
                             options.alpha, metadata);
        case PictureKind::hdr:
            break;
    }
    return write_hdr(path, linear);
}

}  // namespace hm
