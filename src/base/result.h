// Bad input as a value: what went wrong, in which file, at which place, and the exit code it means.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace hm {

// Exit codes of the program; part of the command line's contract (docs/exit-codes.md).
enum class ExitCode : int {
    ok = 0,
    internal = 1,       // a bug, or the machine failed us
    usage = 2,          // the flags make no sense
    unreadable = 3,     // an input file is missing or can't be read
    invalid = 4,        // an input file breaks its format's rules
    unsupported = 5,    // an input file requires what this program does not have
    unwritable = 6,     // an output can't be written
    no_device = 7,      // there is no Vulkan loader or driver, or no device that has what we need;
                        // or no library to denoise with
    device_failed = 8,  // a device that we had ran out of memory or was lost
    warned = 10,        // `info`: the file renders, with warnings; `doctor`: only the CPU draws
    different = 11,     // `compare` only: the pictures differ more than the flags allow
    interrupted = 130,
};

// `place` is a JSON pointer ("/meshes/0/primitives/1"), a byte offset or empty.
struct Error {
    ExitCode code = ExitCode::internal;
    std::string file;
    std::string place;
    std::string message;

    // One line, "file: place: message"; control characters from the input are escaped.
    std::string line() const;
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ExitCode code, std::string file, std::string place,
                                  std::string message) {
    return tl::unexpected<Error>(
        Error{code, std::move(file), std::move(place), std::move(message)});
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
