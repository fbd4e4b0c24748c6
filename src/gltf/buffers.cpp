// Buffers and buffer views (glTF 2.0, 3.6.1).
#include <fmt/format.h>

#include <map>
#include <system_error>

#include "base/files.h"
#include "base/text.h"
#include "gltf/budget.h"
#include "gltf/source.h"
#include "gltf/uri.h"

namespace hm::gltf {
namespace {

// GLB: the first buffer is the BIN chunk if it has no uri.
std::optional<std::span<const std::byte>> chunk_of(const Source& source, std::size_t buffer) {
    return buffer == 0 ? source.binary : std::nullopt;
}

// The target is a hint; only its range is checked.
Result<void> check_target(const Json& view) {
    HM_TRY_ASSIGN(const auto target, view.integer("target"));
    if (target && *target != 34962 && *target != 34963)
        return view.invalid("target", fmt::format("{} is not a target", *target));
    return {};
}

}  // namespace

Result<ByteArray> read_uri(Source& source, const Json& owner, std::string_view uri) {
    if (is_data_uri(uri)) {
        HM_TRY(take_memory(owner, source, uri.size()));  // no less than its decoded size
        auto bytes = decode_data_uri(uri);
        if (!bytes) return owner.invalid("uri", bytes.error());
        return std::move(*bytes);
    }
    const bool allow_external = source.options.allow_external;
    const auto path = decode_path(uri, allow_external);
    if (!path) return owner.invalid("uri", fmt::format("{}: {}", excerpt(uri), path.error()));
    const std::filesystem::path whole = source.folder / *path;
    if (!allow_external)
        if (const auto inside = check_inside(whole, source.folder); !inside)
            return owner.invalid("uri", fmt::format("{}: {}", excerpt(uri), inside.error()));
    std::error_code ignored;  // read_file reports errors
    const std::uintmax_t size = std::filesystem::file_size(whole, ignored);
    if (!ignored) HM_TRY(take_memory(owner, source, size));
    auto bytes = read_file(whole);
    if (!bytes)
        return owner.fail(ErrorKind::unreadable, "uri",
                          fmt::format("{}: {}", excerpt(path->string()), bytes.error().message));
    source.hash.add(*bytes);
    return std::move(*bytes);
}

Result<void> read_buffers(const Json& root, Source& source) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("buffers"));
    std::map<std::string_view, std::span<const std::byte>>
        read;  // a file referenced twice is read once
    for (const Json& item : items) {
        Buffer buffer;
        HM_TRY(name_of(item));
        HM_TRY_ASSIGN(buffer.length, item.required("byteLength", item.integer("byteLength")));
        if (buffer.length == 0) return item.invalid("byteLength", "must not be 0");
        HM_TRY_ASSIGN(const auto uri, item.text("uri"));
        std::optional<std::span<const std::byte>> bytes = chunk_of(source, source.buffers.size());
        if (uri) {
            const auto [known, is_new] = read.try_emplace(*uri);
            if (is_new) {
                HM_TRY_ASSIGN(auto content, read_uri(source, item, *uri));
                known->second = content;  // moving the vector does not move its bytes
                source.storage.push_back(std::move(content));
                add_work(source.budget, known->second.size());
            }
            bytes = known->second;
        }
        if (bytes && bytes->size() < buffer.length)
            return item.invalid("byteLength", fmt::format("{} bytes, but only {} are available",
                                                          buffer.length, bytes->size()));
        if (bytes) buffer.bytes = bytes->first(buffer.length);
        source.buffers.push_back(buffer);
    }
    return {};
}

Result<void> read_buffer_views(const Json& root, Source& source) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("bufferViews"));
    for (const Json& item : items) {
        BufferView view;
        HM_TRY(name_of(item));
        HM_TRY_ASSIGN(
            view.buffer,
            item.required("buffer", item.index("buffer", source.buffers.size(), "buffers")));
        HM_TRY_ASSIGN(const auto offset, item.integer("byteOffset"));
        view.offset = offset.value_or(0);
        HM_TRY_ASSIGN(view.length, item.required("byteLength", item.integer("byteLength")));
        const std::uint64_t available = source.buffers[view.buffer].length;
        if (view.length == 0) return item.invalid("byteLength", "must not be 0");
        if (view.offset > available || view.length > available - view.offset)
            return item.invalid("", fmt::format("bytes {} to {} of a buffer of {}", view.offset,
                                                view.offset + view.length, available));
        HM_TRY_ASSIGN(const auto stride, item.integer("byteStride"));
        if (stride && (*stride < 4 || *stride > 252 || *stride % 4 != 0))
            return item.invalid("byteStride",
                                fmt::format("{} is not a multiple of 4 from 4 to 252", *stride));
        view.stride = static_cast<std::uint32_t>(stride.value_or(0));
        HM_TRY(check_target(item));
        source.views.push_back(view);
    }
    return {};
}

Result<std::span<const std::byte>> view_bytes(const Source& source, std::size_t view) {
    const BufferView& at = source.views[view];
    const Buffer& buffer = source.buffers[at.buffer];
    if (!buffer.bytes)
        return fail(ErrorKind::invalid, source.file, fmt::format("/buffers/{}", at.buffer),
                    "its data is used, but it has neither a uri nor a GLB chunk");
    return buffer.bytes->subspan(at.offset, at.length);
}

}  // namespace hm::gltf
