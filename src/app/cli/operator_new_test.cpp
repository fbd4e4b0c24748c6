// Large arrays are aligned to huge pages and have the requested size.
#include "app/cli/operator_new.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <vector>

namespace hm::cli {
namespace {

TEST(Memory, LargeArraysAreWhole) {
    for (const std::size_t size : {kHugePage, kHugePage + 1, 5 * kHugePage + 123}) {
        const std::vector<std::byte> bytes(size, std::byte(0x5A));
        EXPECT_EQ(std::size_t(std::count(bytes.begin(), bytes.end(), std::byte(0x5A))), size);
    }
}

TEST(Memory, SmallPiecesAreApart) {
    const std::unique_ptr<std::byte[]> first(new std::byte[0]), second(new std::byte[0]);
    EXPECT_NE(first.get(), nullptr);
    EXPECT_NE(first.get(), second.get());
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)  // a sanitizer brings its own operator new
std::uintptr_t past(const void* memory, std::size_t alignment) {
    return reinterpret_cast<std::uintptr_t>(memory) % alignment;
}

TEST(Memory, LargeArraysBeginAtHugePages) {
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    EXPECT_EQ(past(std::vector<std::byte>(kHugePage).data(), kHugePage), 0u);
    EXPECT_EQ(past(std::vector<Line>(kHugePage / sizeof(Line)).data(), kHugePage), 0u);
    EXPECT_EQ(past(std::vector<Line>(3).data(), alignof(Line)), 0u);
}

TEST(Memory, WhatDoesNotFitIsRefused) {
    const volatile std::size_t too_much = std::numeric_limits<std::size_t>::max() / 4;
    EXPECT_THROW((void)::operator new(too_much), std::bad_alloc);
    EXPECT_EQ(::operator new(too_much, std::nothrow), nullptr);
}
#endif

}  // namespace
}  // namespace hm::cli
