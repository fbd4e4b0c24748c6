// Tables of enumerators with their names: one table per enum, shared by command-line flags,
// metadata and reports.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/check.h"

namespace hm {

template <class T>
struct Choice {
    std::string_view name;
    T value;
};

// The name of a value, which must be in the table.
template <class T, std::size_t N>
std::string_view name_of(const Choice<T> (&choices)[N], T value) {
    for (const Choice<T>& choice : choices)
        if (choice.value == value) return choice.name;
    HM_CHECK(false, "value {} has no name", unsigned(value));
    return {};
}

// All names as "a, b, c".
template <class T, std::size_t N>
std::string names_of(const Choice<T> (&choices)[N]) {
    std::string names;
    for (const Choice<T>& choice : choices)
        names += (names.empty() ? "" : ", ") + std::string(choice.name);
    return names;
}

}  // namespace hm
