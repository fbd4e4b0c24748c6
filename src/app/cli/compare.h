// `himalaya compare`: the distance between two pictures, as text or as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli11.h"
#include "app/cli/exit_code.h"
#include "app/cli/measure.h"

namespace hm::cli {

struct CompareOptions {
    std::filesystem::path test, reference;
    std::vector<std::string> layers;  // empty: the beauty; "all": every layer of either
    std::filesystem::path error_picture;
    ErrorMetric error_metric = ErrorMetric::flip;
    std::optional<float> max_rmse, max_relmse, max_flip;
    bool z_test = false;  // both must carry variance, and agree
    bool json = false;
};

// `options` must outlive the parsing; invalid flags throw CLI::ParseError.
void add_compare_flags(CLI::App& app, CompareOptions& options);

// ok, `different` if a limit is exceeded, or the reason why the two can't be compared.
Result<ExitCode> compare(const CompareOptions& options);

}  // namespace hm::cli
