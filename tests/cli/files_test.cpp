// Processes real glTF files with the program: the output of `info --json` must match its schema,
// and `render` must render every scene, material variant and animation without NaN or sanitizer
// findings. Files may be rejected for a required extension.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "app/cli/info.h"
#include "app/cli/options.h"
#include "app/cli/render.h"
#include "base/json_document.h"
#include "cli/info_schema.h"
#include "image/layers.h"
#include "image/test_images.h"
#include "support/asset_files.h"

namespace hm::cli {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

constexpr int kWidth = 24, kHeight = 18;

struct Printed {
    ExitCode code;
    std::string text, error;
};

// As main() does, with standard output captured.
Printed run(const Arguments& arguments) {
    std::vector<const char*> list = {"himalaya"};
    for (const std::string& argument : arguments)
        list.push_back(argument.c_str());
    const Result<CommandLine> line = parse_command_line(int(list.size()), list.data());
    if (!line) return {exit_code(line.error().kind), "", line.error().line()};
    testing::internal::CaptureStdout();
    const Result<ExitCode> code = line->render ? render(*line->render) : info(*line->info);
    const std::string text = testing::internal::GetCapturedStdout();
    return code ? Printed{*code, text, ""}
                : Printed{exit_code(code.error().kind), text, code.error().line()};
}

bool mentions(const fs::path& path, const std::string& text) {
    std::ifstream file(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(file)), {});
    return content.find(text) != std::string::npos;
}

// One picture of the file or several.
struct Shot {
    Arguments flags;
    std::vector<const char*> pictures = {"picture.exr"};
};

std::uint64_t count_of(const Json& info, const char* what) {
    return info.at("/file/counts").value().integer(what).value().value();
}

// Everything to render, as listed by `info`.
std::vector<Shot> shots_of(const Json& info) {
    std::vector<Shot> shots = {
        {{"--aov", "all,variance", "-o", "picture.exr", "-o", "picture.png"}}};
    for (std::uint64_t i = 0, scenes = count_of(info, "scenes"); scenes > 1 && i < scenes; ++i)
        shots.push_back({{"--scene", std::to_string(i), "-o", "picture.exr"}});
    const auto variants = info.at("/file").value().texts("variants").value();
    for (const std::string_view variant : variants)
        shots.push_back({{"--variant", std::string(variant), "-o", "picture.exr"}});
    std::size_t animation = 0;
    const auto animations = info.at("/scene").value().objects("animations").value();
    for (const Json& one : animations) {
        // Its beginning, its middle and its end.
        const double seconds = std::max(one.real("seconds").value().value(), 0.1);
        shots.push_back({{"--animation", std::to_string(animation++), "--frames", "0:2", "--fps",
                          std::to_string(2 / seconds), "-o", "frame#.exr"},
                         {"frame0.exr", "frame1.exr", "frame2.exr"}});
    }
    return shots;
}

class CommandsOfFiles : public testing::Test {
  protected:
    // False if the file is refused.
    bool expect_commands_work(const fs::path& file) {
        const Printed printed = run({"info", file.string(), "--json"});
        test::expect_fits_schema(printed.text);
        if (printed.code == ExitCode::unsupported) {
            EXPECT_TRUE(mentions(file, "extensionsRequired")) << printed.error;
            std::cout << printed.error << '\n';
            return false;
        }
        EXPECT_TRUE(printed.code == ExitCode::ok || printed.code == ExitCode::warned)
            << printed.error;
        const JsonDocument info = JsonDocument::parse(printed.text, "info").value();
        for (const Shot& shot : shots_of(info.root()))
            expect_drawn(file, shot);
        return true;
    }

  private:
    void expect_drawn(const fs::path& file, const Shot& shot) {
        Arguments arguments = {"render",   file.string(), "--size",  "24x18",     "--spp",
                               "2",        "--bounces",   "3",       "--threads", "2",
                               "--device", "cpu",         "--quiet", "--json"};
        for (const std::string& flag : shot.flags)
            arguments.push_back(flag.ends_with(".exr") || flag.ends_with(".png")
                                    ? (folder_ / flag.c_str()).string()
                                    : flag);
        SCOPED_TRACE(shot.flags[0] + " " + shot.flags[1]);
        const Printed printed = run(arguments);
        ASSERT_EQ(printed.code, ExitCode::ok) << printed.error;
        EXPECT_EQ(printed.text.find("were not finite"), std::string::npos) << printed.text;
        for (const char* picture : shot.pictures)
            expect_numbers(folder_ / picture);
    }

    // The variance that so few samples leave unknown is infinite.
    static bool may_hold(const Layer& layer, float value) {
        if (layer.name == "variance") return value >= 0;
        return std::isfinite(value) && (value >= 0 || !layer.name.empty());
    }

    static void expect_numbers(const fs::path& path) {
        const Result<LayeredImage> picture = read_layers(path);
        ASSERT_TRUE(picture) << picture.error().line();
        EXPECT_EQ(picture->data, (PictureWindow{0, 0, kWidth, kHeight}));
        for (const Layer& layer : picture->layers)
            for (const LayerChannel& channel : layer.channels)
                for (const float value : channel.values)
                    ASSERT_TRUE(may_hold(layer, value))
                        << layer.name << "." << channel.name << " is " << value;
        fs::remove(path);
    }

    testing_images::Folder folder_;
};

TEST_F(CommandsOfFiles, Shipped) {
    for (const fs::path& file : test::gltf_files(test::source_folder() / "scenes")) {
        SCOPED_TRACE(file);
        EXPECT_TRUE(expect_commands_work(file));
    }
}

TEST_F(CommandsOfFiles, Assets) {
    const fs::path folder = test::assets_folder();
    if (!fs::is_directory(folder)) GTEST_SKIP() << folder << " is absent";
    std::size_t drawn = 0, refused = 0;
    for (const fs::path& file : test::gltf_files(folder)) {
        SCOPED_TRACE(file);
        ++(expect_commands_work(file) ? drawn : refused);
    }
    std::cout << drawn << " drawn, " << refused << " refused\n";
    EXPECT_GT(drawn, refused);
}

}  // namespace
}  // namespace hm::cli
