// HM_CHECK: a bug stops the program with the condition, the place and the values that broke it.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace hm {
[[noreturn]] void check_failed(const char* file, int line, const char* condition,
                               std::string_view values);
}

// HM_CHECK(i < n, "i = {}, n = {}", i, n)
#define HM_CHECK(condition, ...)                                                            \
    do {                                                                                    \
        if (!(condition)) [[unlikely]]                                                      \
            ::hm::check_failed(__FILE__, __LINE__, #condition, ::fmt::format(__VA_ARGS__)); \
    } while (false)
