// A flag with a typed value.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace hm::cli {

// A flag whose text `parse` turns into the value of `target`, which must outlive the parsing.
template <class Target, class Parse>
CLI::Option* add(CLI::App& app, const std::string& name, const std::string& type, Target& target,
                 Parse parse, const std::string& help) {
    const auto store = [&target, name, parse](const std::string& text) {
        auto value = parse(text);
        if (!value) throw CLI::ValidationError(name, value.error());
        target = *value;
    };
    return app.add_option_function<std::string>(name, store, help)->type_name(type);
}

}  // namespace hm::cli
