// Findings about a machine, and what to do about them.
#pragma once

#include <string>
#include <vector>

#include "app/cli/doctor/machine.h"

namespace hm::cli {

enum class Level {
    good,
    note,     // worth knowing, nothing to do
    warning,  // rendering works, but not with all hardware that seems present
};

struct Finding {
    Level level = Level::good;
    std::string subject;  // a word or two: "Vulkan loader"
    std::string text;
    std::string advice = {};  // what to do; may be empty
};

using Check = std::vector<Finding> (*)(const Machine&);

// In the order of the report. A new check is one more line here.
const std::vector<Check>& all_checks();

std::vector<Finding> check_all(const Machine& machine);

// Which of the features a Vulkan device supports.
struct FeatureTier {
    std::string feature;               // "path tracing"
    std::vector<std::string> missing;  // by name; empty: the device has the feature
};
std::vector<FeatureTier> tiers_of(const VulkanDevice& device);
bool can_trace(const VulkanDevice& device);

}  // namespace hm::cli
