// JSON text, written in order: objects, arrays, strings, numbers, truth values.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace hm {

// key() before each value within an object. Numbers that are not finite become null.
class JsonWriter {
  public:
    JsonWriter& begin_object() { return open('{'); }
    JsonWriter& end_object() { return close('}'); }
    JsonWriter& begin_array() { return open('['); }
    JsonWriter& end_array() { return close(']'); }
    JsonWriter& key(std::string_view name);
    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(double number);
    JsonWriter& value(bool truth);
    JsonWriter& null();
    JsonWriter& value(std::unsigned_integral auto number) { return integer(number); }

    template <class T>
    JsonWriter& field(std::string_view name, const T& content) {
        return key(name).value(content);
    }

    const std::string& text() const { return text_; }

  private:
    JsonWriter& open(char bracket);
    JsonWriter& close(char bracket);
    JsonWriter& integer(std::uint64_t number);
    void separate();
    void quote(std::string_view text);

    std::string text_;
    int depth_ = 0;
    bool first_ = true;  // nothing yet in the current object or array
    bool after_key_ = false;
};

}  // namespace hm
