// One broken file of the corpus: how it is made from a valid one, which rule it breaks, what the
// loader must say and what Khronos' validator says.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace hm::corpus {

// The valid documents that files are made from (bases.h).
enum class Base { minimal, still, moving, extended };

// Changes to the document. `bytes` go into its buffer before all others are done.
struct Edit {
    enum class Kind { set, remove, bytes };
    Kind kind = Kind::set;
    std::string pointer;
    std::string value;       // JSON text, or the bytes
    std::size_t offset = 0;  // of the bytes in the buffer
};
using Edits = std::vector<Edit>;

inline Edit set(std::string pointer, std::string value) {
    return {Edit::Kind::set, std::move(pointer), std::move(value), 0};
}
inline Edit drop(std::string pointer) {
    return {Edit::Kind::remove, std::move(pointer), {}, 0};
}
inline Edit put(std::size_t offset, std::string bytes) {
    return {Edit::Kind::bytes, {}, std::move(bytes), offset};
}

// What the loader does with the file.
//   refused  an error with this code and pointer, and `message` in its text
//   warned   loads with such a warning
//   ignored  loads without a word
// All but the first say why in `reason`.
struct Expected {
    enum class Outcome { refused, warned, ignored };
    Outcome outcome = Outcome::refused;
    std::optional<ErrorKind> kind;
    std::string pointer;
    std::string message;
    std::string reason;
};

inline Expected refused(std::string pointer, std::string message,
                        ErrorKind kind = ErrorKind::invalid) {
    return {Expected::Outcome::refused, kind, std::move(pointer), std::move(message), {}};
}
inline Expected warned(std::string pointer, std::string message, std::string reason) {
    return {
        Expected::Outcome::warned, {}, std::move(pointer), std::move(message), std::move(reason)};
}
inline Expected ignored(std::string reason) {
    return {Expected::Outcome::ignored, {}, {}, {}, std::move(reason)};
}
// Why the validator reports no error, empty where it does.
using Silence = std::string;

struct Case {
    std::string file;     // name
    std::string rule;     // what the file breaks
    std::string section;  // of the specification, or the extension's name
    Base base = Base::still;
    Edits edits;
    Expected expected;
    Silence validator_silence;
    bool glb = false;  // the buffer is the BIN chunk; else it is a data URI
    // Makes the file from the document's text and its buffer where the usual way will not do.
    std::function<std::string(std::string text, std::string buffer)> pack;
};

// The file's bytes.
std::string make_file(const Case& c);

}  // namespace hm::corpus
