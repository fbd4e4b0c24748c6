// A mutable JSON tree for the mutations of the corpus. Any text can be inserted as a value, even
// invalid JSON.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json.h"

namespace hm::corpus {

class Tree {
  public:
    // Throws if the text is not valid JSON.
    static Tree parse(std::string_view text);

    std::string text() const;

    // `pointer` is a JSON pointer without escapes. Its parent must exist; a missing key of an
    // object is added, and so is an element one past the end of an array. A scalar
    // or invalid JSON is used verbatim.
    void set(std::string_view pointer, std::string_view value);
    void remove(std::string_view pointer);

  private:
    enum class Kind { scalar, array, object };

    static Tree from(const Json& value);
    Tree& find(std::string_view pointer);
    std::size_t member_of(std::string_view key) const;  // members_.size() if absent

    Kind kind_ = Kind::scalar;
    std::string scalar_;
    std::vector<std::pair<std::string, Tree>> members_;  // array elements have empty keys
};

}  // namespace hm::corpus
