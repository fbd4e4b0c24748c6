#include "app/cli/output_flag.h"

#include <CLI/CLI.hpp>

#include "output/write.h"

namespace hm::cli {

void add_output_flag(CLI::App& app, std::vector<std::filesystem::path>& outputs,
                     const std::string& help) {
    const auto store = [&outputs](const std::vector<std::string>& paths) {
        for (const std::string& path : paths) {
            if (!picture_kind(path))
                throw CLI::ValidationError("--output",
                                           "\"" + path + "\" does not end in .exr, .png or .hdr");
            outputs.emplace_back(path);
        }
    };
    app.add_option_function<std::vector<std::string>>("-o,--output", store, help)
        ->type_name("PATH")
        ->allow_extra_args(false)
        ->required();
}

}  // namespace hm::cli
