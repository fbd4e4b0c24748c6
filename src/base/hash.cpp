#include "base/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>

#include "base/check.h"

namespace hm {

void Hasher::Release::operator()(XXH3_state_s* state) const {
    XXH3_freeState(state);
}

// noexcept: otherwise GCC 12 warns about uninitialised members of a partially constructed owner.
Hasher::Hasher() noexcept : state_(XXH3_createState()) {
    HM_CHECK(state_ != nullptr, "no memory");
    XXH3_128bits_reset(state_.get());
}

void Hasher::add(std::span<const std::byte> piece) {
    const std::uint64_t size = piece.size();
    XXH3_128bits_update(state_.get(), &size, sizeof(size));
    XXH3_128bits_update(state_.get(), piece.data(), piece.size());
}

void Hasher::add(std::string_view piece) {
    add(std::as_bytes(std::span(piece.data(), piece.size())));
}

std::string Hasher::text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace hm
