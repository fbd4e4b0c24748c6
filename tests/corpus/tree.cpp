#include "corpus/tree.h"

#include <charconv>
#include <stdexcept>

namespace hm::corpus {
namespace {

constexpr std::string_view kSpace = " \n\r\t";

void skip_space(std::string_view text, std::size_t& at) {
    at = std::min(text.find_first_not_of(kSpace, at), text.size());
}

// A string including its quotes, or the text up to the next separator.
std::string_view token(std::string_view text, std::size_t& at) {
    const std::size_t begin = at;
    if (text[at] == '"')
        at = text.find('"', at + 1) + 1;
    else
        at = std::min(text.find_first_of(",:]} \n\r\t", at), text.size());
    return text.substr(begin, at - begin);
}

// Splits off the last token of a JSON pointer.
std::pair<std::string_view, std::string_view> split(std::string_view pointer) {
    const std::size_t slash = pointer.rfind('/');
    return {pointer.substr(0, slash), pointer.substr(slash + 1)};
}

}  // namespace

Tree Tree::parse_value(std::string_view text, std::size_t& at) {
    skip_space(text, at);
    Tree tree;
    if (text[at] != '{' && text[at] != '[') {
        tree.scalar_ = token(text, at);
        return tree;
    }
    tree.kind_ = text[at] == '{' ? Kind::object : Kind::array;
    ++at;
    for (skip_space(text, at); text[at] != '}' && text[at] != ']'; skip_space(text, at)) {
        if (text[at] == ',') {
            ++at;
            continue;
        }
        std::string key;
        if (tree.kind_ == Kind::object) {
            const std::string_view quoted = token(text, at);
            key = quoted.substr(1, quoted.size() - 2);
            skip_space(text, at);
            ++at;  // the colon
        }
        tree.members_.emplace_back(std::move(key), parse_value(text, at));
    }
    ++at;
    return tree;
}

Tree Tree::parse(std::string_view text) {
    std::size_t at = 0;
    return parse_value(text, at);
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
    // Parsed, so that inserted values can be edited further.
    if (value.starts_with('{') || value.starts_with('[')) replacement = parse(value);
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
