// `himalaya denoise`: denoises a picture rendered before, guided by the layers in its file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/cli11.h"
#include "app/cli/exit_code.h"
#include "denoise/denoise.h"
#include "session/denoise_layers.h"
#include "shading/color.h"

namespace hm::cli {

struct DenoiseOptions {
    std::filesystem::path input;
    std::vector<std::filesystem::path> outputs;
    DenoiseDevice device = DenoiseDevice::fastest;
    Guidance guidance;
    std::uint32_t threads = 0;  // 0: all
    std::uint32_t tone_curve = kToneNeutral;
    std::optional<float> exposure = 0.0f;  // none: auto
    bool json = false;
};

// `options` must outlive the parsing; invalid flags throw CLI::ParseError.
void add_denoise_flags(CLI::App& app, DenoiseOptions& options);
// --denoise-device of `render`, --device of `denoise`.
CLI::Option* add_denoise_device(CLI::App& app, const std::string& flag, DenoiseDevice& device);

Result<ExitCode> denoise(const DenoiseOptions& options);

}  // namespace hm::cli
