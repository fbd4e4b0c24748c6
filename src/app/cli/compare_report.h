// The results of `himalaya compare`, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "app/cli/compare.h"

namespace hm::cli {

struct CompareReport {
    std::uint32_t width = 0, height = 0;
    bool encoded = false;  // sRGB, not linear
    std::vector<LayerError> layers;
    // Layers that only one of the files has, by their shown names.
    std::vector<std::string> only_test, only_reference;
    std::vector<std::string> different_channels;  // layers that both have, with other channels
    std::vector<std::string> exceeded;            // limits, in words
};

std::string compare_text(const CompareOptions& options, const CompareReport& report);
std::string compare_json(const CompareOptions& options, const CompareReport& report);

}  // namespace hm::cli
