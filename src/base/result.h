// Bad input as a value: what kind of trouble it is, in which file, at which location, and a
// message.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace hm {

// What kind of trouble an error is, for callers that act on it.
enum class ErrorKind {
    internal,          // a bug, or the machine failed us
    invalid_argument,  // what the caller asks for makes no sense, or does not fit the scene
    unreadable,        // an input file is missing or can't be read
    invalid,           // an input file breaks its format's rules
    unsupported,       // an input file requires what this library does not have
    unwritable,        // an output can't be written
    no_device,         // there is no Vulkan loader or driver, or no device that has what we need;
                       // or no library to denoise with
    device_failed,     // a device that we had ran out of memory or was lost
};

// "invalid argument", "unreadable", ...
std::string_view name_of(ErrorKind kind);

// `location` is a JSON pointer ("/meshes/0/primitives/1"), a byte offset or empty.
struct Error {
    ErrorKind kind = ErrorKind::internal;
    std::string file;
    std::string location;
    std::string message;
    // The setting that is at fault, or that would help ("camera", "any-device"); empty where none
    // is. Front ends turn it into a hint in their own terms.
    std::string setting{};

    // One line, "file: location: message"; control characters from the input are escaped.
    std::string line() const;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorKind kind, std::string file, std::string location,
                                  std::string message) {
    return tl::unexpected<Error>(
        Error{kind, std::move(file), std::move(location), std::move(message)});
}

// An error of kind invalid_argument about one setting.
inline tl::unexpected<Error> fail_setting(std::string setting, std::string message,
                                          std::string file = {}) {
    return tl::unexpected<Error>(Error{ErrorKind::invalid_argument, std::move(file), "",
                                       std::move(message), std::move(setting)});
}

}  // namespace hm

// Propagates a failed Result<void>-like expression; HM_TRY_ASSIGN also binds the value. A reference
// saves moving it, which costs more than most things that readers of small values do.
#define HM_TRY(expression)                                                     \
    do {                                                                       \
        auto hm_result_ = (expression);                                        \
        if (!hm_result_) return tl::unexpected(std::move(hm_result_.error())); \
    } while (false)
#define HM_CONCAT_INNER(a, b) a##b
#define HM_CONCAT(a, b) HM_CONCAT_INNER(a, b)
#define HM_TRY_ASSIGN(declaration, expression) \
    HM_TRY_ASSIGN_NAMED(HM_CONCAT(hm_result_, __LINE__), declaration, expression)
#define HM_TRY_ASSIGN_NAMED(name, declaration, expression)     \
    auto name = (expression);                                  \
    if (!name) return tl::unexpected(std::move(name.error())); \
    declaration = std::move(*name)
