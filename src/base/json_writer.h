// JSON text, written in order: objects, arrays, strings, numbers, booleans.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hm {

// How the members of an object or array are separated.
enum class JsonLayout {
    indented,  // each on a line of its own, indented by its depth
    compact,   // no white space
    lines,     // compact, but a line break after each comma of this object or array
};

// What happens to control characters and the like in strings.
enum class JsonText {
    printable,  // made visible first (base/text.h): for reports that people read
    exact,      // a reader gets back the same text
};

// key() before each value within an object. Numbers that are not finite become null.
class JsonWriter {
  public:
    explicit JsonWriter(JsonText strings = JsonText::printable) : strings_(strings) {}

    // Without a layout: that of the enclosing container, compact within `lines`.
    JsonWriter& begin_object() { return open('{', inherited_layout()); }
    JsonWriter& begin_object(JsonLayout layout) { return open('{', layout); }
    JsonWriter& end_object() { return close('}'); }
    JsonWriter& begin_array() { return open('[', inherited_layout()); }
    JsonWriter& begin_array(JsonLayout layout) { return open('[', layout); }
    JsonWriter& end_array() { return close(']'); }

    JsonWriter& key(std::string_view name);
    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(double number, int digits = 9);
    JsonWriter& value(float number);  // the fewest digits that read back as this float
    JsonWriter& value(bool truth);
    JsonWriter& value(std::unsigned_integral auto number) { return raw_unsigned(number); }
    JsonWriter& value(std::signed_integral auto number) { return raw_signed(number); }
    JsonWriter& null() { return raw("null"); }
    // A value that is JSON already.
    JsonWriter& raw(std::string_view json);

    template <class T>
    JsonWriter& field(std::string_view name, const T& content) {
        return key(name).value(content);
    }
    JsonWriter& field(std::string_view name, double number, int digits) {
        return key(name).value(number, digits);
    }
    // An array of strings or numbers.
    template <class Items>
    JsonWriter& values(const Items& items) {
        begin_array();
        for (const auto& item : items)
            value(item);
        return end_array();
    }

    const std::string& text() const { return text_; }

  private:
    JsonLayout inherited_layout() const;
    JsonWriter& open(char bracket, JsonLayout layout);
    JsonWriter& close(char bracket);
    JsonWriter& raw_unsigned(std::uint64_t number);
    JsonWriter& raw_signed(std::int64_t number);
    void separate();
    void break_line();
    void quote(std::string_view text);

    std::string text_;
    std::vector<JsonLayout> open_;  // of the containers around the next value
    JsonText strings_;
    bool first_ = true;  // nothing yet in the current object or array
    bool after_key_ = false;
};

}  // namespace hm
