#include "library/errors.h"

#include <string>

namespace himalaya {
namespace {

ErrorKind kind_of(hm::ErrorKind kind) {
    switch (kind) {
        case hm::ErrorKind::internal:
            break;
        case hm::ErrorKind::invalid_argument:
            return ErrorKind::invalid_argument;
        case hm::ErrorKind::unreadable:
            return ErrorKind::unreadable;
        case hm::ErrorKind::invalid:
            return ErrorKind::invalid;
        case hm::ErrorKind::unsupported:
            return ErrorKind::unsupported;
        case hm::ErrorKind::unwritable:
            return ErrorKind::unwritable;
        case hm::ErrorKind::no_device:
            return ErrorKind::no_device;
        case hm::ErrorKind::device_failed:
            return ErrorKind::device_failed;
    }
    return ErrorKind::internal;
}

std::string line_of(const std::string& message, const std::string& file,
                    const std::string& location, const std::string& setting) {
    std::string line;
    for (const std::string* part : {&file, &location, &setting})
        if (!part->empty()) line += *part + ": ";
    return line + message;
}

}  // namespace

Error::Error(ErrorKind kind, std::string message, std::string file, std::string location,
             std::string setting)
    : std::runtime_error(line_of(message, file, location, setting)),
      kind_(kind),
      message_(std::move(message)),
      file_(std::move(file)),
      location_(std::move(location)),
      setting_(std::move(setting)) {}

Error::~Error() = default;

void throw_error(const hm::Error& error) {
    throw Error(kind_of(error.kind), error.message, error.file, error.location, error.setting);
}

}  // namespace himalaya
