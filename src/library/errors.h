// Internal errors and exceptions -> himalaya::Error.
#pragma once

#include <himalaya/error.h>

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

#include "base/check.h"
#include "base/result.h"

namespace himalaya {

[[noreturn]] void throw_error(const hm::Error& error);

[[noreturn]] inline void refuse(std::string message) {
    throw Error(ErrorKind::invalid_argument, std::move(message));
}

template <class T>
T value_or_throw(hm::Result<T> result) {
    if (!result) throw_error(result.error());
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

// Calls `function` and turns what it throws into an Error.
template <class Function>
auto guarded(Function&& function) -> decltype(function()) {
    try {
        return function();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::internal, "there is not enough memory");
    } catch (const std::exception& error) {
        throw Error(ErrorKind::internal, error.what());
    }
}

}  // namespace himalaya
