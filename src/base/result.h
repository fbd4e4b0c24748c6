// Errors as values: the kind of error, the file, the location in it and a message.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace hm {

// The kind of an error, for callers that handle kinds differently.
enum class ErrorKind {
    internal,          // a bug, or a failure of the machine
    invalid_argument,  // the caller's request makes no sense or does not fit the scene
    unreadable,        // an input file is missing or can't be read
    invalid,           // an input file violates its format's specification
    unsupported,       // an input file requires a feature that this library does not support
    unwritable,        // an output can't be written
    no_device,         // there is no Vulkan loader or driver, or no device with the required
                       // features; or no denoising library
    device_failed,     // a device in use ran out of memory or was lost
};

// "invalid argument", "unreadable", ...
std::string_view name_of(ErrorKind kind);

// `location` is a JSON pointer ("/meshes/0/primitives/1"), a byte offset or empty.
struct Error {
    ErrorKind kind = ErrorKind::internal;
    std::string file;
    std::string location;
    std::string message;
    // The setting that caused the error or would avoid it ("camera", "any-device"); empty if there
    // is none. Front ends turn it into a hint in their own terms.
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

// An error of kind invalid_argument for one setting.
inline tl::unexpected<Error> fail_setting(std::string setting, std::string message,
                                          std::string file = {}) {
    return tl::unexpected<Error>(Error{ErrorKind::invalid_argument, std::move(file), "",
                                       std::move(message), std::move(setting)});
}

}  // namespace hm

// Returns the error of a failed Result<void>-like expression from the enclosing function;
// HM_TRY_ASSIGN also binds the value. Binding it to a reference avoids a move, which is expensive
// compared with reading a small value.
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
