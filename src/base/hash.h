// Fingerprints of bytes: whether two files are the same, not whether somebody forged one. XXH3 by
// Yann Collet, 128 bits.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct XXH3_state_s;  // the library's

namespace hm {

class Hasher {
  public:
    Hasher() noexcept;
    // Where one piece ends and the next begins counts too.
    void add(std::span<const std::byte> piece);
    void add(std::string_view piece);
    // Of all pieces so far: 32 hexadecimal digits.
    std::string text() const;

  private:
    struct Release {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Release> state_;
};

}  // namespace hm
