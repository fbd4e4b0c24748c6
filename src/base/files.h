// Reads and writes whole files. Writing is atomic: it never leaves a partial file under the final
// name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "base/memory.h"
#include "base/result.h"

namespace hm {

// Reads a regular file. Fails with ErrorKind::unreadable (missing, a folder, no permission).
Result<ByteArray> read_file(const std::filesystem::path& path);

// Checks that a file of `bytes` bytes can be written to `path` now, for use before a long render.
// Creates a temporary file in the same folder, reserves the disk space and removes the file again.
// Fails with ErrorKind::unwritable.
Result<void> check_writable(const std::filesystem::path& path, std::uint64_t bytes = 1);

// Calls `write` with a temporary path in the same folder and renames the result to `path`. On any
// failure the temporary file is removed and `path` is unchanged. On success the file has been
// flushed to disk and survives a power loss. Fails with ErrorKind::unwritable.
Result<void> write_atomically(
    const std::filesystem::path& path,
    const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> write_file_atomically(const std::filesystem::path& path,
                                   std::span<const std::byte> bytes);

}  // namespace hm
