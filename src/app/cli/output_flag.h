// The pictures that a command writes.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace hm::cli {

// -o PATH, once or more often, at least once. `outputs` must outlive the parsing; a name that says
// no kind of picture throws CLI::ParseError.
void add_output_flag(CLI::App& app, std::vector<std::filesystem::path>& outputs,
                     const std::string& help);

}  // namespace hm::cli
