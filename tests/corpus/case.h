// One broken file of the corpus: how it is derived from a valid one, which rule it violates, what
// the loader must report and what the Khronos validator reports.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace hm::corpus {

// The valid documents that files are derived from (bases.h).
enum class Base { minimal, still, moving, extended };

// Changes to the document. `bytes` edits change its buffer, before all other edits.
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
//   refused  fails with this error code and JSON pointer, and `message` in its text
//   warned   loads with such a warning
//   ignored  loads without a warning
// All but the first give the reason in `reason`.
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
// Why the validator reports no error; empty if it does report one.
using Silence = std::string;

struct Case {
    std::string file;     // name
    std::string rule;     // the rule that the file violates
    std::string section;  // of the specification, or the extension's name
    Base base = Base::still;
    Edits edits;
    Expected expected;
    Silence validator_silence;
    bool glb = false;  // the buffer is the BIN chunk; else it is a data URI
    // Custom packing of the document's text and its buffer into a file; empty for the default.
    std::function<std::string(std::string text, std::string buffer)> pack;
};

// The file's bytes.
std::string make_file(const Case& c);

}  // namespace hm::corpus
