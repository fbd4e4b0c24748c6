#include "corpus/tree.h"

#include <charconv>
#include <stdexcept>

#include "base/json_document.h"

namespace hm::corpus {
namespace {

// Splits off the last token of a JSON pointer.
std::pair<std::string_view, std::string_view> split(std::string_view pointer) {
    const std::size_t slash = pointer.rfind('/');
    return {pointer.substr(0, slash), pointer.substr(slash + 1)};
}

}  // namespace

Tree Tree::from(const Json& value) {
    Tree tree;
    switch (value.type()) {
        case JsonType::object:
            tree.kind_ = Kind::object;
            for (const std::string_view key : value.keys())
                tree.members_.emplace_back(key, from(value.at("/" + pointer_token(key)).value()));
            break;
        case JsonType::array:
            tree.kind_ = Kind::array;
            for (const Json& element : value.elements())
                tree.members_.emplace_back("", from(element));
            break;
        default:
            tree.scalar_ = value.compact_text();
    }
    return tree;
}

Tree Tree::parse(std::string_view text) {
    const auto document = JsonDocument::parse(text, "tree");
    if (!document) throw std::logic_error(document.error().line());
    return from(document->root());
}

std::string Tree::text() const {
    if (kind_ == Kind::scalar) return scalar_;
    std::string out(1, kind_ == Kind::object ? '{' : '[');
    for (const auto& [key, value] : members_) {
        if (out.size() > 1) out += ',';
        if (kind_ == Kind::object) out += '"' + key + "\":";
        out += value.text();
    }
    return out + (kind_ == Kind::object ? '}' : ']');
}

std::size_t Tree::member_of(std::string_view key) const {
    std::size_t pointer = 0;
    if (kind_ == Kind::array) {
        std::from_chars(key.data(), key.data() + key.size(), pointer);
        return pointer;
    }
    while (pointer < members_.size() && members_[pointer].first != key)
        ++pointer;
    return pointer;
}

Tree& Tree::find(std::string_view pointer) {
    Tree* at = this;
    while (!pointer.empty()) {
        const std::size_t end = std::min(pointer.find('/', 1), pointer.size());
        const std::size_t member = at->member_of(pointer.substr(1, end - 1));
        if (member >= at->members_.size())
            throw std::logic_error("no such pointer: " + std::string(pointer));
        at = &at->members_[member].second;
        pointer.remove_prefix(end);
    }
    return *at;
}

void Tree::set(std::string_view pointer, std::string_view value) {
    Tree replacement;
    replacement.scalar_ = value;
    const auto [parent_pointer, key] = split(pointer);
    Tree& parent = find(parent_pointer);
    const std::size_t member = parent.member_of(key);
    // Valid values are parsed, so that they can be edited further.
    if (value.starts_with('{') || value.starts_with('['))
        if (const auto document = JsonDocument::parse(value, "value"))
            replacement = from(document->root());
    if (member < parent.members_.size())
        parent.members_[member].second = std::move(replacement);
    else
        parent.members_.emplace_back(parent.kind_ == Kind::object ? key : "",
                                     std::move(replacement));
}

void Tree::remove(std::string_view pointer) {
    const auto [parent_pointer, key] = split(pointer);
    Tree& parent = find(parent_pointer);
    const std::size_t member = parent.member_of(key);
    if (member >= parent.members_.size())
        throw std::logic_error("nothing to remove: " + std::string(pointer));
    parent.members_.erase(parent.members_.begin() + std::ptrdiff_t(member));
}

}  // namespace hm::corpus
