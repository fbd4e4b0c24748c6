// JSON that can be changed: what the corpus's mutations work on. Numbers keep the text they were
// written with, and any text may be put in as a value, also one that is no JSON.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hm::corpus {

class Tree {
  public:
    // `text` is trusted: well formed, without escapes in keys.
    static Tree parse(std::string_view text);

    std::string text() const;

    // `pointer` is a JSON pointer without escapes. Its parent must exist; a key that an object does
    // not have is added, and so is an element one past an array's end. The value stands as given.
    void set(std::string_view pointer, std::string_view value);
    void remove(std::string_view pointer);

  private:
    enum class Kind { scalar, array, object };

    static Tree parse_value(std::string_view text, std::size_t& at);
    Tree& find(std::string_view pointer);
    std::size_t member_of(std::string_view key) const;  // members_.size() where absent

    Kind kind_ = Kind::scalar;
    std::string scalar_;
    std::vector<std::pair<std::string, Tree>> members_;  // an array's have empty keys
};

}  // namespace hm::corpus
