// The scenes that come with the program, demo:NAME.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace hm::cli {

inline constexpr std::string_view kDemoPrefix = "demo:";

struct Demo {
    std::filesystem::path scene;
    // Flags without dashes and their values, from NAME.json; `env` is made a path from here.
    std::vector<std::pair<std::string, std::string>> flags;
};

// Looks in the folder that the variable HIMALAYA_SCENES names, in ../share/himalaya/scenes from the
// program, then in the source tree it was built from. An unknown name fails with the known ones.
Result<Demo> find_demo(std::string_view name);

// A flat JSON object of strings; `file` is for messages.
Result<std::vector<std::pair<std::string, std::string>>> parse_flags(std::string_view json,
                                                                     const std::string& file);

}  // namespace hm::cli
