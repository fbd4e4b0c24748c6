#include "gltf/images.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>

#include "gltf/materials.h"
#include "image/read.h"

namespace hm::gltf {
namespace {

// Decoded pixels of all images together. A few kilobytes of PNG can ask for a gigabyte.
constexpr std::uint64_t kMaxImageBytes = 1ull << 35;

// The bytes of an image, in `storage` unless they lie in a buffer.
Result<std::span<const std::byte>> image_bytes(const Json& item, const Source& source,
                                               std::vector<std::byte>& storage) {
    HM_TRY_ASSIGN(const auto uri, item.text("uri"));
    HM_TRY_ASSIGN(const auto view, item.index("bufferView", source.views.size(), "buffer views"));
    if (uri && view) return item.invalid("", "has both a uri and a bufferView");
    if (view) return view_bytes(source, *view);
    if (!uri) return item.invalid("", "has neither a uri nor a bufferView");
    HM_TRY_ASSIGN(storage, read_uri(source, item, *uri));
    return storage;
}

// The name of a picture format that glTF files carry by extension only, else empty.
std::string_view foreign_format(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) return "WebP";
    if (text.starts_with("\xABKTX 20\xBB")) return "KTX2";
    if (text.starts_with("DDS ")) return "DDS";
    if (text.substr(0, 12).ends_with("ftypavif")) return "AVIF";
    return {};
}

Result<Image> read_one(const Json& item, const Source& source) {
    std::vector<std::byte> storage;
    HM_TRY_ASSIGN(const auto bytes, image_bytes(item, source, storage));
    const std::string_view key = item.has("uri") ? "uri" : "bufferView";
    if (const std::string_view format = foreign_format(bytes); !format.empty())
        return item.fail(ExitCode::unsupported, key,
                         fmt::format("is a {} image; PNG and JPEG are read", format));
    HM_TRY_ASSIGN(const std::string name, item.name());
    auto image = read_texture_image(bytes, name);
    if (!image) return item.fail(image.error().code, key, std::move(image.error().message));
    return std::move(*image);
}

// Which of the file's images are read, as their places in the scene's list or kUnset.
std::vector<int> choose(const std::vector<Material>& materials, const std::vector<bool>& used,
                        std::size_t image_count, std::vector<std::size_t>& chosen) {
    std::vector<bool> needed(image_count, false);
    for (std::size_t m = 0; m < materials.size(); ++m)
        for (const TextureSlot* slot : texture_slots(materials[m]))
            if (used[m] && slot->image != kUnset) needed[std::size_t(slot->image)] = true;
    std::vector<int> new_index(image_count, kUnset);
    for (std::size_t i = 0; i < image_count; ++i) {
        if (!needed[i]) continue;
        new_index[i] = static_cast<int>(chosen.size());
        chosen.push_back(i);
    }
    return new_index;
}

}  // namespace

Result<std::vector<Image>> read_images(const Json& root, Source& source,
                                       std::vector<Material>& materials,
                                       const std::vector<bool>& used) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("images"));
    std::vector<std::size_t> chosen;
    const std::vector<int> new_index = choose(materials, used, items.size(), chosen);
    for (Material& material : materials)
        for (TextureSlot* slot : texture_slots(material))
            if (slot->image != kUnset) slot->image = new_index[std::size_t(slot->image)];

    std::vector<Result<Image>> read(chosen.size());
    std::atomic<std::uint64_t> total = 0;
    tbb::parallel_for(std::size_t{0}, chosen.size(), [&](std::size_t i) {
        if (total > kMaxImageBytes) return;
        read[i] = read_one(items[chosen[i]], source);
        if (read[i]) total += read[i]->pixels.size();
    });
    // Which images were skipped depends on timing, so this error goes before all others.
    if (total > kMaxImageBytes)
        return root.invalid("images", fmt::format("decode to more than {} bytes", kMaxImageBytes));
    std::vector<Image> images;
    images.reserve(read.size());
    for (Result<Image>& image : read) {
        if (!image) return tl::unexpected(std::move(image.error()));
        images.push_back(std::move(*image));
    }
    return images;
}

}  // namespace hm::gltf
