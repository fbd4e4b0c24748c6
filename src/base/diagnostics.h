// Warnings and notes collected while reading input. One that repeats at several locations is stored
// once with a count. A warning says that a picture may not be as intended; a note reports something
// that does not affect it.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hm {

struct Warning {
    std::string file;
    std::string location;  // of the first occurrence: a JSON pointer or empty
    std::string message;
    std::size_t count = 1;

    std::string line() const;  // "file: location: message (3 times)"; control characters escaped
};

// Both lists are in order of first occurrence. Not thread-safe.
class Diagnostics {
  public:
    void warn(std::string file, std::string location, std::string message, std::size_t count = 1) {
        warnings_.add({std::move(file), std::move(location), std::move(message), count});
    }
    void note(std::string file, std::string location, std::string message, std::size_t count = 1) {
        notes_.add({std::move(file), std::move(location), std::move(message), count});
    }
    const std::vector<Warning>& warnings() const { return warnings_.all; }
    const std::vector<Warning>& notes() const { return notes_.all; }

  private:
    struct List {
        void add(Warning warning);

        std::vector<Warning> all;
        std::unordered_map<std::string, std::size_t> index;  // file and message -> all
    };
    List warnings_, notes_;
};

}  // namespace hm
