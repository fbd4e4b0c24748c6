// Layout of --help: a column of flags and a column of text, wrapped for narrow terminals.
#pragma once

#include <CLI/Formatter.hpp>
#include <string>

namespace hm::cli {

class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter();
    std::string make_option_opts(const CLI::Option* option) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace hm::cli
