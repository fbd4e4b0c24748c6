#include "base/hash.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace hm {
namespace {

std::string hash_of(std::initializer_list<std::string_view> pieces) {
    Hasher hasher;
    for (const std::string_view piece : pieces)
        hasher.add(piece);
    return hasher.text();
}

// The published hash of empty input, from https://github.com/Cyan4973/xxHash.
TEST(Hash, IsXxh3) {
    EXPECT_EQ(Hasher().text(), "99aa06d3014798d86001c324468d497f");
}

TEST(Hash, OneBitChangesIt) {
    std::string text(5000, 'a');
    std::set<std::string> seen = {hash_of({text})};
    for (const std::size_t place : {0, 1, 63, 240, 1024, 4999}) {
        std::string other = text;
        other[place] ^= 1;
        EXPECT_TRUE(seen.insert(hash_of({other})).second) << place;
    }
    EXPECT_EQ(hash_of({text}).size(), 32u);
}

TEST(Hash, PiecesCount) {
    EXPECT_EQ(hash_of({"ab", "c"}), hash_of({"ab", "c"}));
    EXPECT_NE(hash_of({"ab", "c"}), hash_of({"a", "bc"}));
    EXPECT_NE(hash_of({"ab", "c"}), hash_of({"abc"}));
    EXPECT_NE(hash_of({""}), hash_of({}));
    EXPECT_NE(hash_of({"a", "b"}), hash_of({"b", "a"}));
}

}  // namespace
}  // namespace hm
