// Whole files in and out. Writing never leaves half a file under the final name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "base/result.h"

namespace hm {

// The bytes of a regular file. Fails with ExitCode::unreadable (missing, a folder, no permission).
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path);

// Calls `write` with a temporary path in the same folder and renames the result to `path`; on any
// failure the temporary file is removed and `path` is as it was. Fails with ExitCode::unwritable.
Result<void> write_atomically(
    const std::filesystem::path& path,
    const std::function<Result<void>(const std::filesystem::path&)>& write);

Result<void> write_file_atomically(const std::filesystem::path& path,
                                   std::span<const std::byte> bytes);

}  // namespace hm
