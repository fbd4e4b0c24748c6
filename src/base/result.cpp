#include "base/result.h"

#include "base/text.h"

namespace hm {

std::string_view name_of(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::internal:
            return "internal";
        case ErrorKind::invalid_argument:
            return "invalid argument";
        case ErrorKind::unreadable:
            return "unreadable";
        case ErrorKind::invalid:
            return "invalid";
        case ErrorKind::unsupported:
            return "unsupported";
        case ErrorKind::unwritable:
            return "unwritable";
        case ErrorKind::no_device:
            return "no device";
        case ErrorKind::device_failed:
            return "device failed";
    }
    return "";
}

std::string Error::line() const {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!location.empty()) text += location + ": ";
    return printable(text + message);
}

}  // namespace hm
