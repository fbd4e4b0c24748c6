#include "app/cli/frames.h"

#include <fmt/format.h>

#include <algorithm>

namespace hm::cli {
namespace {

struct Run {
    std::size_t begin = 0, length = 0;  // none: length 0
};

Run find_run(const std::string& name) {
    const std::size_t begin = name.find('#');
    if (begin == name.npos) return {};
    const std::size_t end = std::min(name.find_first_not_of('#', begin), name.size());
    return {begin, end - begin};
}

}  // namespace

Parsed<FrameRange> parse_frames(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == text.npos)
        return tl::unexpected(fmt::format("\"{}\" is not two frame numbers A:B", text));
    const auto first = parse_integer(text.substr(0, colon), 0, kMaxFrame);
    if (!first) return tl::unexpected(first.error());
    const auto last = parse_integer(text.substr(colon + 1), *first, kMaxFrame);
    if (!last) return tl::unexpected(last.error());
    return FrameRange{*first, *last};
}

bool has_frame_pattern(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    const Run run = find_run(name);
    return run.length > 0 && name.find('#', run.begin + run.length) == name.npos;
}

std::filesystem::path frame_path(const std::filesystem::path& pattern, std::uint32_t number) {
    std::string name = pattern.filename().string();
    const Run run = find_run(name);
    name.replace(run.begin, run.length, fmt::format("{:0{}}", number, run.length));
    return pattern.parent_path() / name;
}

RenderOptions frame_options(const RenderOptions& options, std::uint32_t number) {
    RenderOptions frame = options;
    frame.settings = settings_of_frame(options.settings, number);
    for (std::filesystem::path& path : frame.outputs)
        path = frame_path(path, number);
    std::erase_if(frame.given,
                  [](const auto& flag) { return flag.first == "frames" || flag.first == "seed"; });
    frame.given.emplace_back("at", fmt::format("{}", *frame.settings.animation.at));
    frame.given.emplace_back("seed", fmt::format("{}", frame.settings.path.seed));
    return frame;
}

}  // namespace hm::cli
