// What the command line asks for, checked as far as possible without the scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/compare.h"
#include "app/cli/denoise.h"
#include "app/cli/merge.h"
#include "base/result.h"
#include "gltf/load.h"
#include "session/fingerprint.h"
#include "session/settings.h"

namespace hm::cli {

inline constexpr std::uint32_t kMaxFrame = 9999999;

struct FrameRange {
    std::uint32_t first = 0, last = 0;  // both are drawn
};

struct RenderOptions {
    std::string input;  // as given: a path or demo:NAME
    std::filesystem::path scene_file;
    LoadOptions load;
    std::vector<std::filesystem::path> outputs;

    RenderSettings settings;
    KeepSettings keep;
    DeviceChoice device;
    std::uint32_t threads = 0;  // 0: all
    std::optional<FrameRange> frames;
    bool json = false;
    bool quiet = false;

    // Flags and values that shaped the picture, a demo's own first: for reports and metadata. The
    // value of a flag without one is empty.
    NamedValues given;
};

struct InfoOptions {
    std::string input;  // as given: a path or demo:NAME
    std::filesystem::path scene_file;
    LoadOptions load;
    bool json = false;
};

struct DoctorOptions {
    bool json = false;
};

struct BenchOptions {
    std::vector<std::string> inputs;  // paths or demo:NAME
    std::uint32_t width = 1920, height = 1080;
    DeviceChoice device;
};

struct CommandLine {
    std::optional<RenderOptions> render;
    std::optional<InfoOptions> info;
    std::optional<DoctorOptions> doctor;
    std::optional<BenchOptions> bench;
    std::optional<CompareOptions> compare;
    std::optional<DenoiseOptions> denoise;
    std::optional<MergeOptions> merge;
    std::string text;  // help or version, to be printed instead
};

// Fails with ErrorKind::invalid_argument, or with a demo's own error.
Result<CommandLine> parse_command_line(int count, const char* const* arguments);

// Those of `himalaya render` without flags except a demo's own, and without output.
Result<RenderOptions> default_render_options(const std::string& input);

}  // namespace hm::cli
