// Non-cryptographic hashes of bytes, to compare files but not to detect tampering: 128-bit XXH3 by
// Yann Collet.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct XXH3_state_s;  // from xxhash.h

namespace hm {

class Hasher {
  public:
    Hasher() noexcept;
    // The boundaries between pieces are part of the hash.
    void add(std::span<const std::byte> piece);
    void add(std::string_view piece);
    // The hash of all pieces so far as 32 hexadecimal digits.
    std::string text() const;

  private:
    struct Release {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Release> state_;
};

}  // namespace hm
