#include "base/json_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "base/text.h"

namespace hm {

JsonLayout JsonWriter::inherited_layout() const {
    if (open_.empty()) return JsonLayout::indented;
    return open_.back() == JsonLayout::lines ? JsonLayout::compact : open_.back();
}

void JsonWriter::break_line() {
    text_ += '\n';
    text_.append(2 * open_.size(), ' ');
}

void JsonWriter::separate() {
    if (after_key_) {
        after_key_ = false;
        return;
    }
    if (open_.empty()) return;
    if (!first_) text_ += ',';
    if (open_.back() == JsonLayout::indented) break_line();
    if (open_.back() == JsonLayout::lines && !first_) text_ += '\n';
    first_ = false;
}

JsonWriter& JsonWriter::open(char bracket, JsonLayout layout) {
    separate();
    text_ += bracket;
    open_.push_back(layout);
    first_ = true;
    return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
    const JsonLayout layout = open_.back();
    open_.pop_back();
    if (layout == JsonLayout::indented && !first_) break_line();
    text_ += bracket;
    first_ = false;
    return *this;
}

void JsonWriter::quote(std::string_view text) {
    text_ += '"';
    for (const char c : strings_ == JsonText::exact ? std::string(text) : printable(text)) {
        if (static_cast<unsigned char>(c) < 0x20) {
            text_ += fmt::format("\\u{:04x}", unsigned(c));
            continue;
        }
        if (c == '"' || c == '\\') text_ += '\\';
        text_ += c;
    }
    text_ += '"';
}

JsonWriter& JsonWriter::key(std::string_view name) {
    separate();
    quote(name);
    text_ += !open_.empty() && open_.back() == JsonLayout::indented ? ": " : ":";
    after_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
    separate();
    quote(text);
    return *this;
}

JsonWriter& JsonWriter::value(double number, int digits) {
    return raw(std::isfinite(number) ? fmt::format("{:.{}g}", number, digits) : "null");
}

JsonWriter& JsonWriter::value(float number) {
    return raw(std::isfinite(number) ? fmt::format("{}", number) : "null");
}

JsonWriter& JsonWriter::value(bool truth) {
    return raw(truth ? "true" : "false");
}

JsonWriter& JsonWriter::raw(std::string_view json) {
    separate();
    text_ += json;
    return *this;
}

JsonWriter& JsonWriter::raw_unsigned(std::uint64_t number) {
    return raw(fmt::format("{}", number));
}

JsonWriter& JsonWriter::raw_signed(std::int64_t number) {
    return raw(fmt::format("{}", number));
}

}  // namespace hm
