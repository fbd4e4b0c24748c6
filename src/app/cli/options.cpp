#include "app/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string_view>

#include "app/cli/demo.h"
#include "app/cli/help.h"
#include "app/cli/load_flags.h"
#include "app/cli/render_flags.h"
#include "app/cli/values.h"

namespace hm::cli {
namespace {

using Arguments = std::vector<std::string>;

// Flags that exclude each other or belong together: one on the command line also replaces a demo's
// values for the others.
constexpr std::array<std::array<std::string_view, 4>, 4> kReplacedTogether = {{
    {"camera", "eye", "target", "up"},
    {"at", "frames", "fps", ""},
    {"spp", "time", "samples", ""},
    {"size", "crop", "", ""},
}};

// Flags that do not influence the picture.
constexpr std::array<std::string_view, 12> kNotSettings = {
    "FILE",  "output",       "json",           "quiet",      "threads", "help",
    "every", "memory-limit", "allow-external", "checkpoint", "resume",  "any-device"};

bool was_given(const RenderOptions& options, std::string_view flag) {
    const auto given = [&](std::string_view name) {
        return !name.empty() && std::any_of(options.given.begin(), options.given.end(),
                                            [&](const auto& pair) { return pair.first == name; });
    };
    for (const auto& group : kReplacedTogether)
        if (std::find(group.begin(), group.end(), flag) != group.end())
            return std::any_of(group.begin(), group.end(), given);
    return given(flag);
}

void add_info_flags(CLI::App& app, InfoOptions& options) {
    app.add_option("FILE", options.input,
                   "A .glb or .gltf file, or demo:NAME for a scene that is included")
        ->required();
    app.add_flag("--json", options.json, "Print JSON instead of text");
    add_load_flags(app, options.load);
    app.footer(
        "The exit code is 0 without warnings, 10 with warnings, and that of a failed rendering if "
        "the file is refused.");
}

void add_doctor_flags(CLI::App& app, DoctorOptions& options) {
    app.add_flag("--json", options.json, "Print JSON instead of text");
    app.footer(
        "The exit code is 0 if a GPU and every other device render what the CPU renders, 10 if "
        "there "
        "are warnings or only the CPU renders, 8 if a device renders a wrong picture or none.");
}

void add_bench_flags(CLI::App& app, BenchOptions& options) {
    app.add_option("FILE", options.inputs, "Scenes: files, or demo:NAME")->required();
    add_device_flag(app, options.device);
    const auto size = [&options](const std::string& text) {
        const Parsed<Size> parsed = parse_size(text);
        if (!parsed) throw CLI::ValidationError("--size", parsed.error());
        options.width = parsed->width;
        options.height = parsed->height;
    };
    app.add_option_function<std::string>("--size", size, "The pictures' pixels (1920x1080)")
        ->type_name("WxH");
    app.footer(
        "Prints JSON: rates, and on a GPU also the rate of the same rays traced by empty shaders. "
        "Names contain the units, except for bytes and counts.");
}

Result<std::filesystem::path> scene_file_of(const std::string& input) {
    if (!input.starts_with(kDemoPrefix)) return std::filesystem::path(input);
    HM_TRY_ASSIGN(const Demo demo, find_demo(std::string_view(input).substr(kDemoPrefix.size())));
    return demo.scene;
}

// Throws CLI11's exceptions.
CommandLine parse(const Arguments& arguments) {
    CommandLine line;
    CLI::App app("Physically based renderer for glTF", "himalaya");
    app.set_version_flag("--version", "himalaya " HIMALAYA_VERSION);
    app.require_subcommand(1);
    app.formatter(std::make_shared<HelpFormatter>());  // for subcommands too
    RenderOptions options;
    CLI::App& render = *app.add_subcommand("render", "Render a scene into one or more pictures");
    add_render_flags(render, options);
    InfoOptions info_options;
    CLI::App& info = *app.add_subcommand("info", "List the contents of a scene file");
    add_info_flags(info, info_options);
    DoctorOptions doctor_options;
    CLI::App& doctor =
        *app.add_subcommand("doctor", "Check this machine's devices and render on each");
    add_doctor_flags(doctor, doctor_options);
    BenchOptions bench_options;
    CLI::App& bench = *app.add_subcommand("bench", "Measure how fast a device renders scenes");
    add_bench_flags(bench, bench_options);
    CompareOptions compare_options;
    CLI::App& compare = *app.add_subcommand("compare", "Measure the distance between two pictures");
    add_compare_flags(compare, compare_options);
    DenoiseOptions denoise_options;
    CLI::App& denoise = *app.add_subcommand("denoise", "Denoise a rendered .exr");
    add_denoise_flags(denoise, denoise_options);
    MergeOptions merge_options;
    CLI::App& merge = *app.add_subcommand("merge", "Merge parts of a rendering (--samples)");
    add_merge_flags(merge, merge_options);
    try {
        app.parse(Arguments(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        line.text = app.help();
        return line;
    } catch (const CLI::CallForVersion& version) {
        line.text = std::string(version.what()) + "\n";
        return line;
    }
    if (info.parsed()) {
        line.info = std::move(info_options);
        return line;
    }
    if (doctor.parsed()) {
        line.doctor = doctor_options;
        return line;
    }
    if (bench.parsed()) {
        line.bench = std::move(bench_options);
        return line;
    }
    if (denoise.parsed()) {
        line.denoise = std::move(denoise_options);
        return line;
    }
    if (merge.parsed()) {
        line.merge = std::move(merge_options);
        return line;
    }
    if (compare.parsed()) {
        line.compare = std::move(compare_options);
        return line;
    }
    for (const CLI::Option* option : render.get_options()) {
        const std::string name = option->get_single_name();
        if (option->count() > 0 &&
            std::find(kNotSettings.begin(), kNotSettings.end(), name) == kNotSettings.end())
            options.given.emplace_back(
                name, option->get_items_expected_max() == 0 ? "" : option->results().front());
    }
    SamplingSettings& sampling = options.settings.sampling;
    if (sampling.time && render.get_option("--spp")->count() == 0) sampling.samples = kMaxSamples;
    KeepSettings& keep = options.keep;
    keep.begin_if_missing = !keep.resume.empty() && keep.checkpoint == keep.resume;
    if (keep.checkpoint.empty()) keep.checkpoint = keep.resume;
    line.render = std::move(options);
    return line;
}

Result<CommandLine> parse_with_demo(const Arguments& arguments, const RenderOptions& first) {
    HM_TRY_ASSIGN(const Demo demo,
                  find_demo(std::string_view(first.input).substr(kDemoPrefix.size())));
    Arguments all = {arguments.front()};
    for (const auto& [flag, value] : demo.flags)
        if (!was_given(first, flag)) all.push_back(fmt::format("--{}={}", flag, value));
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    try {
        CommandLine line = parse(all);
        if (line.render) line.render->scene_file = demo.scene;
        return line;
    } catch (const CLI::ParseError& error) {
        // The command line alone was valid, so this comes from the demo's flags.
        return fail(ErrorKind::invalid,
                    std::filesystem::path(demo.scene).replace_extension(".json").string(), "",
                    error.what());
    }
}

// Throws CLI11's exceptions.
Result<CommandLine> parse_render(const Arguments& arguments, CommandLine line) {
    if (line.render->input.starts_with(kDemoPrefix))
        return parse_with_demo(arguments, *line.render);
    line.render->scene_file = line.render->input;
    return line;
}

}  // namespace

Result<CommandLine> parse_command_line(int count, const char* const* arguments) {
    const std::span<const char* const> given(arguments, std::size_t(count));
    const Arguments list(given.begin() + (given.empty() ? 0 : 1), given.end());
    try {
        CommandLine line = parse(list);
        if (line.info) {
            HM_TRY_ASSIGN(line.info->scene_file, scene_file_of(line.info->input));
        }
        if (!line.render) return line;
        HM_TRY_ASSIGN(line, parse_render(list, std::move(line)));
        if (line.render) HM_TRY(check_render_options(*line.render));
        return line;
    } catch (const CLI::ParseError& error) {
        return fail(ErrorKind::invalid_argument, "", "", error.what());
    }
}

Result<RenderOptions> default_render_options(const std::string& input) {
    const Arguments list = {"render", "--output=none.exr", "--", input};
    HM_TRY_ASSIGN(CommandLine line, parse_render(list, parse(list)));
    line.render->outputs.clear();
    return std::move(*line.render);
}

}  // namespace hm::cli
