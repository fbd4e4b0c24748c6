// CLI11's names, for headers: what parses includes <CLI/CLI.hpp>, which takes seconds to compile.
#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI
