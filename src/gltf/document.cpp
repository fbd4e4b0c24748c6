#include "gltf/document.h"

#include <utility>

namespace hm::gltf {
namespace {

constexpr std::string_view kExtensions = "extensions";

Result<void> check_extensions(const Json& object) {
    return object.check_object_of_objects(kExtensions);
}

}  // namespace

Result<std::optional<Json>> extension_of(const Json& object, std::string_view name) {
    HM_TRY_ASSIGN(const std::optional<Json> extensions, object.object(kExtensions));
    if (!extensions) return std::nullopt;
    return extensions->object(name);
}

Result<std::string> name_of(const Json& object) {
    HM_TRY_ASSIGN(const auto& name, object.text("name"));
    return std::string(name.value_or(""));
}

Result<JsonDocument> parse_document(std::span<const std::byte> text, const std::string& file,
                                    std::size_t readable_behind) {
    const auto reject = [&](std::string message) {
        return hm::fail(ErrorKind::invalid, file, "", std::move(message));
    };
    const auto byte = [&](std::size_t i) { return std::to_integer<unsigned>(text[i]); };
    // glTF forbids a byte order mark; RFC 8259 (8.1) lets a reader ignore it.
    if (text.size() >= 3 && byte(0) == 0xEF && byte(1) == 0xBB && byte(2) == 0xBF)
        text = text.subspan(3);
    if (text.size() >= 2 && (byte(0) == 0xFF || byte(0) == 0xFE) && byte(0) + byte(1) == 0x1FD)
        return reject("is UTF-16; glTF must be UTF-8");
    HM_TRY_ASSIGN(auto document, JsonDocument::parse(text, file,
                                                     {.readable_behind = readable_behind,
                                                      .check_object = check_extensions,
                                                      .counted = kExtensions,
                                                      .skipped = "extras"}));
    if (document.root().type() != JsonType::object)
        return reject("is not a glTF file: its JSON is not an object");
    return document;
}

}  // namespace hm::gltf
