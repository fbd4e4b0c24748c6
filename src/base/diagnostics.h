// Warnings collected while reading input. A warning that repeats at several locations is stored
// once with a count.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace hm {

struct Warning {
    std::string file;
    std::string location;  // of the first occurrence: a JSON pointer or empty
    std::string message;
    std::size_t count = 1;

    std::string line() const;  // "file: location: message (3 times)"; control characters escaped
};

// Warnings in order of first occurrence. Not thread-safe.
class Diagnostics {
  public:
    void warn(std::string file, std::string location, std::string message, std::size_t count = 1);
    const std::vector<Warning>& warnings() const { return warnings_; }

  private:
    std::vector<Warning> warnings_;
    std::unordered_map<std::string, std::size_t> index_;  // file and message -> warnings_
};

}  // namespace hm
