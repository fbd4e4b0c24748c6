// A whole JSON text, parsed by simdjson.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/json.h"
#include "base/result.h"

namespace hm {

// Nesting allowed in a text.
inline constexpr std::size_t kMaxJsonDepth = 256;

using KeyCounts = std::map<std::string_view, std::size_t>;

struct JsonOptions {
    // Bytes after the text that may be read, whatever they are. With enough of them the text need
    // not be copied.
    std::size_t readable_behind = 0;
    Result<void> (*check_object)(const Json& object) = nullptr;  // see JsonContext
    // Counts the keys of all objects that are the value of the key `counted`, except inside the
    // values of the key `skipped`. An option because the document is walked anyway.
    std::string_view counted = {}, skipped = {};
};

class JsonDocument {
  public:
    // A key that is repeated in an object is an error: which value counts would depend on the
    // reader. `file` is for messages.
    static Result<JsonDocument> parse(std::span<const std::byte> text, std::string file,
                                      const JsonOptions& options = {});
    static Result<JsonDocument> parse(std::string_view text, std::string file) {
        return parse(std::as_bytes(std::span(text)), std::move(file));
    }

    // Valid while this document, or the one that it was moved to, lives.
    const Json& root() const { return root_; }
    const KeyCounts& key_counts() const { return key_counts_; }

  private:
    struct Storage;  // the parser's memory
    struct Free {
        void operator()(Storage* storage) const;
    };

    JsonDocument(std::unique_ptr<Storage, Free> storage, Json root, KeyCounts counts)
        : storage_(std::move(storage)), root_(std::move(root)), key_counts_(std::move(counts)) {}

    std::unique_ptr<Storage, Free> storage_;
    Json root_;
    KeyCounts key_counts_;
};

}  // namespace hm
