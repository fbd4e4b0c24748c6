// `himalaya merge`: merges parts of a rendering, each a range of the samples.
#pragma once

#include <filesystem>
#include <vector>

#include "app/cli/cli11.h"
#include "app/cli/exit_code.h"

namespace hm::cli {

struct MergeOptions {
    std::vector<std::filesystem::path> parts, outputs;
    bool part = false;  // write a part again
};

// `options` must outlive the parsing; invalid flags throw CLI::ParseError.
void add_merge_flags(CLI::App& app, MergeOptions& options);

Result<ExitCode> merge(const MergeOptions& options);

}  // namespace hm::cli
