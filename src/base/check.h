// HM_CHECK: an assertion that throws an exception with the condition, its source location and the
// offending values.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace hm {

// Indicates a bug. Do not catch it locally: front ends report it and abort the operation.
class CheckFailure : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

// Throws CheckFailure.
[[noreturn]] void check_failed(const char* file, int line, const char* condition,
                               std::string_view values);

}  // namespace hm

// HM_CHECK(i < n, "i = {}, n = {}", i, n)
#define HM_CHECK(condition, ...)                                                            \
    do {                                                                                    \
        if (!(condition)) [[unlikely]]                                                      \
            ::hm::check_failed(__FILE__, __LINE__, #condition, ::fmt::format(__VA_ARGS__)); \
    } while (false)
