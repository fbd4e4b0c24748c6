// The scenes shipped with the program, demo:NAME.
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
    // Flags without dashes and their values, from NAME.json; `env` is resolved to a path.
    std::vector<std::pair<std::string, std::string>> flags;
};

// Searches the folder named by the variable HIMALAYA_SCENES, ../share/himalaya/scenes relative to
// the program, then the source tree it was built from. For an unknown name the error lists all.
Result<Demo> find_demo(std::string_view name);

// A flat JSON object of strings; `file` is for messages.
Result<std::vector<std::pair<std::string, std::string>>> parse_flags(std::string_view json,
                                                                     const std::string& file);

}  // namespace hm::cli
