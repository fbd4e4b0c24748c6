// The pictures that a command writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/cli11.h"

namespace hm::cli {

// -o PATH, at least once. `outputs` must outlive the parsing; an unknown extension throws
// CLI::ParseError.
void add_output_flag(CLI::App& app, std::vector<std::filesystem::path>& outputs,
                     const std::string& help);

}  // namespace hm::cli
