// Which driver manifests are found where, on file trees made for the purpose.
#include "app/cli/drivers.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

namespace hm::cli {
namespace {

namespace fs = std::filesystem;

class Drivers : public testing::Test {
  protected:
    void SetUp() override {
        root_ = fs::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    fs::path write(const std::string& path, const std::string& library) {
        const fs::path file = root_ / path;
        fs::create_directories(file.parent_path());
        std::ofstream(file) << R"({"file_format_version": "1.0.0", "ICD": {"library_path": ")"
                            << library << R"(", "api_version": "1.3.0"}})";
        return file;
    }
    Environment environment() const {
        return [this](const char* name) {
            const auto found = variables_.find(name);
            return found == variables_.end() ? "" : found->second;
        };
    }
    std::vector<DriverManifest> find() const { return find_manifests(environment(), root_); }

    fs::path root_;
    std::map<std::string, std::string> variables_;
};

TEST_F(Drivers, AreFoundWhereTheLoaderLooks) {
    const fs::path one = write("usr/share/vulkan/icd.d/radeon_icd.json", "libvulkan_radeon.so");
    const fs::path two = write("etc/vulkan/icd.d/nvidia_icd.json", "libGLX_nvidia.so.0");
    write("usr/share/vulkan/icd.d/notes.txt", "ignored");
    const auto found = find();
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].file, two);
    EXPECT_EQ(found[0].driver, "libGLX_nvidia.so.0");
    EXPECT_EQ(found[1].file, one);
    EXPECT_TRUE(found[0].is_searched && found[1].is_searched);
    EXPECT_EQ(drivers_to_add(found, environment()), "");
}

TEST_F(Drivers, OfAContainerAreAdded) {
    const fs::path file =
        write("usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json", "libGLX_nvidia.so.0");
    write("usr/share/vulkan/icd.d/lvp_icd.json", "libvulkan_lvp.so");
    EXPECT_EQ(drivers_to_add(find(), environment()), file.string());
}

TEST_F(Drivers, AreNotAddedTwice) {
    write("usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json", "libGLX_nvidia.so.0");
    write("usr/share/vulkan/icd.d/nvidia_icd.x86_64.json", "/usr/lib/libGLX_nvidia.so.0");
    EXPECT_EQ(drivers_to_add(find(), environment()), "");
}

TEST_F(Drivers, TheUsersChoiceStands) {
    write("usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json", "libGLX_nvidia.so.0");
    write("usr/share/vulkan/icd.d/radeon_icd.json", "libvulkan_radeon.so");
    const fs::path mine = write("mine/icd.json", "./lib/libvulkan_mine.so");
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
        variables_ = {{name, mine.string()}};
        const auto found = find();
        ASSERT_EQ(found.size(), 2u) << name;
        EXPECT_EQ(found[0].driver, (root_ / "mine/lib/libvulkan_mine.so").string());
        EXPECT_FALSE(found[1].is_searched);
        EXPECT_EQ(drivers_to_add(found, environment()), "") << name;
    }
}

TEST_F(Drivers, AManifestThatLeadsNowhereSaysWhy) {
    const auto trouble = [&](const fs::path& file) {
        variables_ = {{"VK_DRIVER_FILES", file.string()}};
        return manifest_trouble(find().at(0));
    };
    EXPECT_EQ(trouble("/nowhere/icd.json"), "there is no such file");
    const fs::path empty = write("mine/empty.json", "");
    EXPECT_EQ(trouble(empty), "the manifest names no library");
    const std::string missing = trouble(write("mine/missing.json", "libGLX_missing.so.0"));
    EXPECT_TRUE(missing.starts_with("libGLX_missing.so.0: ")) << missing;
    EXPECT_EQ(trouble(write("mine/other.json", "libc.so.6")),
              "libc.so.6 is not a Vulkan driver: it has no vk_icdGetInstanceProcAddr");
}

TEST_F(Drivers, ALibraryThatIsMissingIsNamed) {
    EXPECT_EQ(library_trouble("libc.so.6"), "");
    EXPECT_NE(library_trouble("libGLX_missing.so.0").find("libGLX_missing.so.0"),
              std::string::npos);
}

}  // namespace
}  // namespace hm::cli
