// What every function of the library throws.
#pragma once

#include <himalaya/export.h>

#include <stdexcept>
#include <string>

namespace himalaya {

enum class ErrorKind {
    internal,          // a bug, or out of memory
    invalid_argument,  // the call or its settings make no sense, or do not fit the scene
    unreadable,        // an input file is missing or can't be read
    invalid,           // an input file breaks its format's rules
    unsupported,       // an input file requires a feature that the library lacks
    unwritable,        // an output can't be written
    no_device,         // no suitable Vulkan device, or no denoiser library
    device_failed,     // a device ran out of memory or was lost
};

class HIMALAYA_API Error : public std::runtime_error {
  public:
    Error(ErrorKind kind, std::string message, std::string file = {}, std::string location = {},
          std::string setting = {});
    ~Error() override;

    // what() is "file: location: message".
    ErrorKind kind() const { return kind_; }
    const std::string& message() const { return message_; }
    const std::string& file() const { return file_; }
    // A JSON pointer, a byte offset or empty.
    const std::string& location() const { return location_; }
    // The setting at fault ("camera"), or empty.
    const std::string& setting() const { return setting_; }

  private:
    ErrorKind kind_;
    std::string message_, file_, location_, setting_;
};

}  // namespace himalaya
