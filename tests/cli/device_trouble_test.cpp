// The whole program without a Vulkan driver or with a loader that can't be opened, as simulated by
// environment variables.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/cli/exit_code.h"

namespace {

using hm::cli::ExitCode;
namespace fs = std::filesystem;

struct Outcome {
    ExitCode code;
    std::string text;  // of both streams
    bool says(const std::string& part) const { return text.find(part) != text.npos; }
};

class DeviceTrouble : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        picture_ = folder_ / "picture.exr";
    }
    void TearDown() override { fs::remove_all(folder_); }

    Outcome run(const std::string& arguments) const {
        std::string command = "env ";
        command.append(environment_).append(" " HIMALAYA_PROGRAM " ").append(arguments);
        FILE* pipe = ::popen(command.append(" 2>&1").c_str(), "r");
        std::string text;
        std::array<char, 256> buffer{};
        while (std::fgets(buffer.data(), int(buffer.size()), pipe) != nullptr)
            text += buffer.data();
        const int status = ::pclose(pipe);
        return {ExitCode(WIFEXITED(status) ? WEXITSTATUS(status) : -1), text};
    }
    Outcome render(const std::string& device) const {
        std::string arguments = "render demo:cornell --size 16x16 --spp 1 --device ";
        return run(arguments.append(device).append(" -o ").append(picture_.string()));
    }
    void without_driver() { environment_ = "VK_DRIVER_FILES=/nowhere/icd.json"; }
    // The dynamic linker takes the first file with this name, which is not a library.
    void without_loader() {
        std::ofstream(folder_ / "libvulkan.so.1") << "not a library\n";
        environment_ = "LD_LIBRARY_PATH=";
        environment_.append(folder_.string());
    }

    fs::path folder_, picture_;
    std::string environment_;
};

TEST_F(DeviceTrouble, WithoutADriverVulkanIsAnErrorThatSaysWhatToDo) {
    without_driver();
    const Outcome o = render("vulkan");
    EXPECT_EQ(o.code, ExitCode::no_device) << o.text;
    EXPECT_TRUE(o.says("himalaya: error: Vulkan: the loader finds no device")) << o.text;
    EXPECT_TRUE(o.says("himalaya doctor")) << o.text;
    EXPECT_FALSE(fs::exists(picture_));
}

TEST_F(DeviceTrouble, WithoutADriverAutoDrawsOnTheCpuAndSaysSo) {
    without_driver();
    const Outcome o = render("auto");
    EXPECT_EQ(o.code, ExitCode::ok) << o.text;
    EXPECT_TRUE(o.says("himalaya: drawing on the CPU: Vulkan: ")) << o.text;
    EXPECT_TRUE(fs::exists(picture_));
}

TEST_F(DeviceTrouble, WithoutALoaderTheProgramStartsAndNamesIt) {
    without_loader();
    EXPECT_EQ(run("--version").code, ExitCode::ok);
    const Outcome o = render("vulkan");
    EXPECT_EQ(o.code, ExitCode::no_device) << o.text;
    EXPECT_TRUE(o.says("no loader")) << o.text;
    EXPECT_TRUE(o.says("libvulkan1")) << o.text;
    EXPECT_EQ(render("auto").code, ExitCode::ok);
    EXPECT_EQ(render("cpu").code, ExitCode::ok);
}

TEST_F(DeviceTrouble, TheDoctorNamesBoth) {
    without_loader();
    Outcome o = run("doctor");
    EXPECT_EQ(o.code, ExitCode::warned) << o.text;
    EXPECT_TRUE(o.says("Vulkan loader")) << o.text;
    EXPECT_TRUE(o.says("libvulkan1")) << o.text;
    without_driver();
    o = run("doctor --json");
    EXPECT_EQ(o.code, ExitCode::warned) << o.text;
    EXPECT_TRUE(o.says("/nowhere/icd.json")) << o.text;
}

}  // namespace
