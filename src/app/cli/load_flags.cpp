#include "app/cli/load_flags.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

namespace hm::cli {

Parsed<std::uint64_t> parse_bytes(std::string_view text) {
    constexpr std::string_view kUnits = "KMGT";
    std::uint64_t count = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, count);
    unsigned shift = 0;
    if (error == std::errc() && end - stopped == 1 && kUnits.find(*stopped) != kUnits.npos)
        shift = 10 * (unsigned(kUnits.find(*stopped)) + 1);
    const bool is_whole = error == std::errc() && (stopped == end || shift != 0);
    if (!is_whole || count == 0 || count > (~std::uint64_t{0} >> shift))
        return tl::unexpected(fmt::format("\"{}\" is not a size like 4G", text));
    return count << shift;
}

void add_load_flags(CLI::App& app, LoadOptions& options) {
    app.add_option("--scene", options.scene,
                   "The file's scene of this name or index (the file's default)")
        ->type_name("NAME|INDEX");
    app.add_option("--variant", options.variant, "Use this material variant of the file (none)")
        ->type_name("NAME");
    const auto limit = [&options](const std::string& text) {
        const Parsed<std::uint64_t> bytes = parse_bytes(text);
        if (!bytes) throw CLI::ValidationError("--memory-limit", bytes.error());
        options.memory_limit = *bytes;
    };
    app.add_option_function<std::string>(
           "--memory-limit", limit,
           "Refuse a scene that needs more bytes to load: a number, with K, M, G or T (three "
           "quarters of the available memory, 16G at most)")
        ->type_name("SIZE");
    app.add_flag("--allow-external", options.allow_external,
                 "Read buffers and images from anywhere on this machine, not only below the file's "
                 "folder. Never use it with a file from someone else");
}

}  // namespace hm::cli
