// Warnings gathered while input is read. The same warning at many places is kept once with a count.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace hm {

struct Warning {
    std::string file;
    std::string location;  // where it was seen first: a JSON pointer or empty
    std::string message;
    std::size_t count = 1;

    std::string line() const;  // "file: location: message (3 times)"; control characters escaped
};

// In the order of their first appearance. Not for several threads at once.
class Diagnostics {
  public:
    void warn(std::string file, std::string location, std::string message, std::size_t count = 1);
    const std::vector<Warning>& warnings() const { return warnings_; }

  private:
    std::vector<Warning> warnings_;
    std::unordered_map<std::string, std::size_t> index_;  // file and message -> warnings_
};

}  // namespace hm
