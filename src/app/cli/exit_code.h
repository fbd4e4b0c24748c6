// Exit codes of the program; part of the command line's contract (docs/exit-codes.md).
#pragma once

#include "base/result.h"

namespace hm::cli {

enum class ExitCode : int {
    ok = 0,
    internal = 1,
    usage = 2,
    unreadable = 3,
    invalid = 4,
    unsupported = 5,
    unwritable = 6,
    no_device = 7,
    device_failed = 8,
    warned = 10,     // `info`: the file renders, with warnings; `doctor`: only the CPU draws
    different = 11,  // `compare` only: the pictures differ more than the flags allow
    interrupted = 130,
};

constexpr ExitCode exit_code(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::invalid_argument:
            return ExitCode::usage;
        case ErrorKind::unreadable:
            return ExitCode::unreadable;
        case ErrorKind::invalid:
            return ExitCode::invalid;
        case ErrorKind::unsupported:
            return ExitCode::unsupported;
        case ErrorKind::unwritable:
            return ExitCode::unwritable;
        case ErrorKind::no_device:
            return ExitCode::no_device;
        case ErrorKind::device_failed:
            return ExitCode::device_failed;
        case ErrorKind::internal:
            break;
    }
    return ExitCode::internal;
}

}  // namespace hm::cli
