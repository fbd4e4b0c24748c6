#include "gltf/images.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "base/text.h"
#include "gltf/asset.h"
#include "gltf/budget.h"
#include "gltf/uri.h"
#include "image/codecs.h"
#include "image/decoded_size.h"
#include "image/read.h"
#include "scene/material_parameters.h"

namespace hm::gltf {
namespace {

// An encoded image: in `storage`, or in a buffer.
struct Encoded {
    ByteArray storage;
    std::span<const std::byte> bytes;
    std::string name;
    std::uint64_t decoded_bytes = 0;  // charged to the budget
};

// The name of an image format that glTF allows by extension only, else empty.
std::string_view foreign_format(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) return "WebP";
    if (text.starts_with("\xABKTX 20\xBB")) return "KTX2";
    if (text.starts_with("DDS ")) return "DDS";
    if (text.substr(0, 12).ends_with("ftypavif")) return "AVIF";
    return {};
}

// The content decides; viewers tolerate a wrong media type.
void check_media_type(const Json& item, Source& source, std::string_view declared,
                      FileFormat format) {
    const std::string_view actual = format == FileFormat::png    ? "image/png"
                                    : format == FileFormat::jpeg ? "image/jpeg"
                                                                 : "";
    if (declared.empty() || actual.empty() || declared == actual ||
        declared == "application/octet-stream")
        return;
    source.warn(item.pointer(),
                fmt::format("declared as {}, but it is {}", excerpt(declared), actual));
}

std::string_view key_of(const Json& item) {
    return item.has("uri") ? "uri" : "bufferView";
}

Result<void> fetch_bytes(const Json& item, Source& source, Encoded& out) {
    HM_TRY_ASSIGN(const auto uri, item.text("uri"));
    HM_TRY_ASSIGN(const auto view, item.index("bufferView", source.views.size(), "buffer views"));
    if (uri && view) return item.invalid("", "has both a uri and a bufferView");
    if (!uri && !view) return item.invalid("", "has neither a uri nor a bufferView");
    if (view) {
        HM_TRY_ASSIGN(out.bytes, view_bytes(source, *view));
    } else {
        HM_TRY_ASSIGN(out.storage, read_uri(source, item, *uri));
        out.bytes = out.storage;
    }
    HM_TRY_ASSIGN(const auto type, item.text("mimeType"));
    const std::string_view declared = type                       ? *type
                                      : uri && is_data_uri(*uri) ? media_type(*uri)
                                                                 : std::string_view();
    check_media_type(item, source, declared, file_format(out.bytes));
    return {};
}

// Everything but the pixels, whose memory is charged to the budget.
Result<Encoded> fetch(const Json& item, Source& source) {
    Encoded out;
    HM_TRY(fetch_bytes(item, source, out));
    if (const std::string_view format = foreign_format(out.bytes); !format.empty())
        return item.fail(
            ErrorKind::unsupported, key_of(item),
            fmt::format("is a {} image; only PNG and JPEG are supported (convert with: {})", format,
                        kPicturesToPng));
    HM_TRY_ASSIGN(out.name, name_of(item));
    out.decoded_bytes = decoded_size(out.bytes).value_or(0);
    HM_TRY(take_memory(item, source, out.decoded_bytes));
    return out;
}

// Maps each image of the file to its index in the scene, or kUnset if it is not read.
std::vector<int> choose(const std::vector<Material>& materials, const std::vector<bool>& used,
                        std::size_t image_count, std::vector<std::size_t>& chosen) {
    std::vector<bool> needed(image_count, false);
    for (std::size_t m = 0; m < materials.size(); ++m)
        for (const MaterialTexture& texture : material_textures()) {
            const int image = (materials[m].*texture.slot).image;
            if (used[m] && image != kUnset) needed[std::size_t(image)] = true;
        }
    std::vector<int> new_index(image_count, kUnset);
    for (std::size_t i = 0; i < image_count; ++i) {
        if (!needed[i]) continue;
        new_index[i] = static_cast<int>(chosen.size());
        chosen.push_back(i);
    }
    return new_index;
}

// Decoding needs about as much memory for rows or coefficients as for the pixels. Each thread
// decodes one image at a time.
Result<void> check_memory_of_decoding(const std::vector<Encoded>& encoded, const Source& source) {
    std::vector<std::uint64_t> sizes;
    for (const Encoded& e : encoded)
        sizes.push_back(e.decoded_bytes);
    const std::size_t at_once =
        std::min(sizes.size(), std::size_t(tbb::this_task_arena::max_concurrency()));
    std::partial_sort(sizes.begin(), sizes.begin() + std::ptrdiff_t(at_once), sizes.end(),
                      std::greater<>());
    const auto largest =
        std::accumulate(sizes.begin(), sizes.begin() + std::ptrdiff_t(at_once), std::uint64_t{0});
    return check_memory(source.budget, largest, source.file, "/images");
}

}  // namespace

Result<std::vector<TextureImage>> read_images(const Json& root, Source& source,
                                              std::vector<Material>& materials,
                                              const std::vector<bool>& used) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("images"));
    std::vector<std::size_t> chosen;
    const std::vector<int> new_index = choose(materials, used, items.size(), chosen);
    for (Material& material : materials)
        for (const MaterialTexture& texture : material_textures()) {
            int& image = (material.*texture.slot).image;
            if (image != kUnset) image = new_index[std::size_t(image)];
        }

    std::vector<Encoded> encoded;
    for (const std::size_t i : chosen) {
        HM_TRY_ASSIGN(encoded.emplace_back(), fetch(items[i], source));
    }
    HM_TRY(check_memory_of_decoding(encoded, source));
    std::vector<Result<TextureImage>> read(chosen.size());
    std::vector<ReadWarnings> warnings(chosen.size());
    tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) {
        read[i] = read_texture_image(encoded[i].bytes, encoded[i].name, warnings[i]);
        encoded[i].storage = {};
    });
    std::vector<TextureImage> images;
    images.reserve(read.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const Json& item = items[chosen[i]];
        if (!read[i])
            return item.fail(read[i].error().kind, key_of(item),
                             std::move(read[i].error().message));
        for (std::string& warning : warnings[i])
            source.warn(item.pointer_of(key_of(item)), std::move(warning));
        images.push_back(std::move(*read[i]));
    }
    return images;
}

}  // namespace hm::gltf
