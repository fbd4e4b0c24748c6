// Enumerators with their names: one table per enumeration serves flags, metadata and reports.
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

// The name of a value that the table has.
template <class T, std::size_t N>
std::string_view name_of(const Choice<T> (&choices)[N], T value) {
    for (const Choice<T>& choice : choices)
        if (choice.value == value) return choice.name;
    HM_CHECK(false, "value {} has no name", unsigned(value));
    return {};
}

// "a, b, c".
template <class T, std::size_t N>
std::string names_of(const Choice<T> (&choices)[N]) {
    std::string names;
    for (const Choice<T>& choice : choices)
        names += (names.empty() ? "" : ", ") + std::string(choice.name);
    return names;
}

}  // namespace hm
