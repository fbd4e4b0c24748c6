// Whole files in and out. Writing never leaves half a file under the final name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "base/memory.h"
#include "base/result.h"

namespace hm {

// The bytes of a regular file. Fails with ErrorKind::unreadable (missing, a folder, no permission).
Result<ByteArray> read_file(const std::filesystem::path& path);

// Whether a file of so many bytes could be written to `path` now: for asking before hours of work.
// Makes a temporary file in its folder, reserves the room and removes it again. Fails with
// ErrorKind::unwritable.
Result<void> check_writable(const std::filesystem::path& path, std::uint64_t bytes = 1);

// Calls `write` with a temporary path in the same folder and renames the result to `path`; on any
// failure the temporary file is removed and `path` is as it was. Once this returns, the file also
// survives a loss of power. Fails with ErrorKind::unwritable.
Result<void> write_atomically(
    const std::filesystem::path& path,
    const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> write_file_atomically(const std::filesystem::path& path,
                                   std::span<const std::byte> bytes);

}  // namespace hm
