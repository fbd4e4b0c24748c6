// HM_CHECK: a bug becomes an exception with the condition, its location in the source and the
// values that broke it.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace hm {

// Not to be handled where it might have been thrown: front ends report it and give up the
// operation.
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
