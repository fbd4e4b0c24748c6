#include "gltf/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace hm::gltf {
namespace {

namespace dom = simdjson::dom;

bool is_compound(dom::element value) {
    const dom::element_type type = value.type();
    return type == dom::element_type::ARRAY || type == dom::element_type::OBJECT;
}

// A key that is in the list twice, or nothing.
std::optional<std::string_view> find_twice(std::span<std::string_view> keys) {
    // Nearly all objects are so short that it costs least to compare all with all.
    constexpr std::size_t kShort = 12;
    if (keys.size() > kShort) {
        std::sort(keys.begin(), keys.end());
        const auto twice = std::adjacent_find(keys.begin(), keys.end());
        return twice == keys.end() ? std::nullopt : std::optional(*twice);
    }
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (std::find(keys.begin(), keys.begin() + std::ptrdiff_t(i), keys[i]) !=
            keys.begin() + std::ptrdiff_t(i))
            return keys[i];
    return std::nullopt;
}

// One walk over a whole document, for what has to be looked for everywhere.
class Survey {
  public:
    explicit Survey(ExtensionUses& uses) : uses_(uses) {}

    // The JSON pointer to the first key that stands twice in its object, if there is one: which of
    // the two values counts would depend on the reader.
    std::optional<std::string> repeated_key(dom::element root) {
        std::string pointer;
        return visit(root, false, pointer) ? std::optional(pointer) : std::nullopt;
    }

  private:
    // Whether a key stands twice in an object, anywhere below `value`, an array or an object: its
    // tokens are put in front of `pointer`.
    bool visit(dom::element value, bool in_extras, std::string& pointer) {
        return value.is_array() ? visit_array(value, in_extras, pointer)
                                : visit_object(value, in_extras, pointer);
    }
    bool visit_array(dom::array values, bool in_extras, std::string& pointer);
    bool visit_object(dom::object object, bool in_extras, std::string& pointer);

    ExtensionUses& uses_;
    std::vector<std::string_view> open_;  // the keys of the objects around
};

bool Survey::visit_array(dom::array values, bool in_extras, std::string& pointer) {
    std::size_t i = 0;
    for (const dom::element item : values) {
        if (is_compound(item) && visit(item, in_extras, pointer)) {
            pointer = fmt::format("/{}{}", i, pointer);
            return true;
        }
        ++i;
    }
    return false;
}

bool Survey::visit_object(dom::object object, bool in_extras, std::string& pointer) {
    const std::size_t first = open_.size();
    // The parser's pairs of key and value are slow to make.
    for (auto member = object.begin(), end = object.end(); member != end; ++member) {
        const std::string_view key = member.key();
        open_.push_back(key);
        const dom::element item = member.value();
        if (!is_compound(item)) continue;
        if (key == "extensions" && !in_extras && item.is_object())
            for (const auto& [name, extension] : dom::object(item))
                ++uses_[name];
        if (!visit(item, in_extras || key == "extras", pointer)) continue;
        pointer = fmt::format("/{}{}", escaped(key), pointer);
        return true;
    }
    const auto twice = find_twice(std::span(open_).subspan(first));
    if (twice) pointer = fmt::format("/{}", escaped(*twice));
    open_.resize(first);
    return twice.has_value();
}

}  // namespace

Result<Document> parse_json(dom::parser& parser, std::span<const std::byte> text,
                            const std::string& file, std::size_t readable_behind) {
    const auto reject = [&](std::string message) {
        return hm::fail(ErrorKind::invalid, file, "", std::move(message));
    };
    const auto byte = [&](std::size_t i) { return std::to_integer<unsigned>(text[i]); };
    // glTF forbids a byte order mark; RFC 8259 (8.1) lets a reader ignore it.
    if (text.size() >= 3 && byte(0) == 0xEF && byte(1) == 0xBB && byte(2) == 0xBF)
        text = text.subspan(3);
    if (text.size() >= 2 && (byte(0) == 0xFF || byte(0) == 0xFE) && byte(0) + byte(1) == 0x1FD)
        return reject("is UTF-16 text; glTF is UTF-8");

    if (text.empty()) return reject("is empty");
    simdjson::error_code status = parser.allocate(text.size(), kMaxJsonDepth);
    dom::element root;
    if (status == simdjson::SUCCESS)
        // Where the text can't have the padding that simdjson reads past its end, a copy has it.
        status = parser
                     .parse(reinterpret_cast<const char*>(text.data()), text.size(),
                            readable_behind < simdjson::SIMDJSON_PADDING)
                     .get(root);
    if (status == simdjson::DEPTH_ERROR)
        return reject(fmt::format("is nested more than {} levels deep", kMaxJsonDepth));
    if (status == simdjson::UTF8_ERROR) return reject("is not valid UTF-8");
    if (status == simdjson::EMPTY) return reject("is empty");
    if (status == simdjson::NUMBER_ERROR)
        return reject("is not valid JSON: a number is malformed or beyond a 64-bit float");
    if (status == simdjson::MEMALLOC)
        return hm::fail(ErrorKind::unreadable, file, "", "its JSON does not fit in memory");
    if (status != simdjson::SUCCESS)
        return reject(fmt::format("is not valid JSON: {}", simdjson::error_message(status)));
    if (!root.is_object()) return reject("is not a glTF file: its JSON is no object");
    ExtensionUses uses;
    if (const auto pointer = Survey(uses).repeated_key(root))
        return hm::fail(ErrorKind::invalid, file, *pointer, "stands twice in its object");
    return Document{Json(root, "", &file), std::move(uses)};
}

}  // namespace hm::gltf
