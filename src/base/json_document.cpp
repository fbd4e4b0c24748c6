#include "base/json_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "base/json_node.h"

namespace hm {
namespace {

namespace dom = simdjson::dom;

bool is_compound(dom::element value) {
    const dom::element_type type = value.type();
    return type == dom::element_type::ARRAY || type == dom::element_type::OBJECT;
}

std::optional<std::string_view> find_repeated(std::span<std::string_view> keys) {
    // Most objects are so short that comparing all pairs is fastest.
    constexpr std::size_t kShort = 12;
    if (keys.size() > kShort) {
        std::sort(keys.begin(), keys.end());
        const auto found = std::adjacent_find(keys.begin(), keys.end());
        return found == keys.end() ? std::nullopt : std::optional(*found);
    }
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const auto end = keys.begin() + std::ptrdiff_t(i);
        if (std::find(keys.begin(), end, keys[i]) != end) return keys[i];
    }
    return std::nullopt;
}

// One walk over a document that finds repeated keys and counts keys.
class Walk {
  public:
    Walk(const JsonOptions& options, KeyCounts& counts) : options_(options), counts_(counts) {}

    // The JSON pointer to the first repeated key.
    std::optional<std::string> find_repeated_key(dom::element root) {
        std::string pointer;
        const bool found = is_compound(root) && visit(root, options_.counted.empty(), pointer);
        return found ? std::optional(pointer) : std::nullopt;
    }

  private:
    // Whether a key is repeated anywhere in `value`, an array or an object; its tokens are
    // prepended to `pointer`.
    bool visit(dom::element value, bool skipped, std::string& pointer) {
        return value.is_array() ? visit_array(value, skipped, pointer)
                                : visit_object(value, skipped, pointer);
    }
    bool visit_array(dom::array values, bool skipped, std::string& pointer);
    bool visit_object(dom::object object, bool skipped, std::string& pointer);

    const JsonOptions& options_;
    KeyCounts& counts_;
    std::vector<std::string_view> open_;  // keys of the enclosing objects
};

bool Walk::visit_array(dom::array values, bool skipped, std::string& pointer) {
    std::size_t i = 0;
    for (const dom::element item : values) {
        if (is_compound(item) && visit(item, skipped, pointer)) {
            pointer = fmt::format("/{}{}", i, pointer);
            return true;
        }
        ++i;
    }
    return false;
}

bool Walk::visit_object(dom::object object, bool skipped, std::string& pointer) {
    const std::size_t first = open_.size();
    // The parser's key-value pairs are slow to make.
    for (auto member = object.begin(), end = object.end(); member != end; ++member) {
        const std::string_view key = member.key();
        open_.push_back(key);
        const dom::element item = member.value();
        if (!is_compound(item)) continue;
        if (!skipped && key == options_.counted && item.is_object())
            for (const auto& [name, value] : dom::object(item))
                ++counts_[name];
        if (!visit(item, skipped || key == options_.skipped, pointer)) continue;
        pointer = fmt::format("/{}{}", pointer_token(key), pointer);
        return true;
    }
    const auto repeated = find_repeated(std::span(open_).subspan(first));
    if (repeated) pointer = fmt::format("/{}", pointer_token(*repeated));
    open_.resize(first);
    return repeated.has_value();
}

// What is wrong with a text that the parser rejects.
Error describe(simdjson::error_code status, const std::string& file) {
    const auto invalid = [&](std::string message) {
        return Error{ErrorKind::invalid, file, "", std::move(message)};
    };
    switch (status) {
        case simdjson::DEPTH_ERROR:
            return invalid(fmt::format("is nested more than {} levels deep", kMaxJsonDepth));
        case simdjson::UTF8_ERROR:
            return invalid("is not valid UTF-8");
        case simdjson::EMPTY:
            return invalid("is empty");
        case simdjson::NUMBER_ERROR:
            return invalid("is not valid JSON: a number is malformed or beyond a 64-bit float");
        case simdjson::MEMALLOC:
            return {ErrorKind::unreadable, file, "", "its JSON does not fit in memory"};
        default:
            return invalid(fmt::format("is not valid JSON: {}", simdjson::error_message(status)));
    }
}

}  // namespace

struct JsonDocument::Storage {
    dom::parser parser;
    JsonContext context;
};

void JsonDocument::Free::operator()(Storage* storage) const {
    delete storage;
}

Result<JsonDocument> JsonDocument::parse(std::span<const std::byte> text, std::string file,
                                         const JsonOptions& options) {
    if (text.empty()) return tl::unexpected(describe(simdjson::EMPTY, file));
    std::unique_ptr<Storage, Free> storage(new Storage);
    storage->context = {std::move(file), options.check_object};
    const std::string& name = storage->context.file;

    simdjson::error_code status = storage->parser.allocate(text.size(), kMaxJsonDepth);
    dom::element root;
    if (status == simdjson::SUCCESS)
        // simdjson reads past the end: it copies the text unless enough bytes follow.
        status = storage->parser
                     .parse(reinterpret_cast<const char*>(text.data()), text.size(),
                            options.readable_behind < simdjson::SIMDJSON_PADDING)
                     .get(root);
    if (status != simdjson::SUCCESS) return tl::unexpected(describe(status, name));

    KeyCounts counts;
    if (const auto pointer = Walk(options, counts).find_repeated_key(root))
        return fail(ErrorKind::invalid, name, *pointer, "is repeated in its object");
    Json value(to_node(root), "", &storage->context);
    return JsonDocument(std::move(storage), std::move(value), std::move(counts));
}

}  // namespace hm
