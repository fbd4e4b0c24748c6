// Findings of `himalaya doctor` for made-up machines.
#include "app/cli/doctor/checks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hm::cli {
namespace {

constexpr const char* kTracing = "VK_KHR_ray_tracing_pipeline";
constexpr const char* kReorder = "VK_NV_ray_tracing_invocation_reorder";

VulkanDevice make_device(std::string name, bool is_software, bool traces) {
    VulkanDevice d;
    d.name = std::move(name);
    d.kind = is_software ? "CPU" : "discrete GPU";
    d.is_software = is_software;
    d.api_version = "1.3.300";
    d.memory_bytes = 24ull << 30;
    d.capabilities = {{"Vulkan 1.3", "the version this is written for", true, true},
                      {kTracing, "tracing rays", true, traces},
                      {kReorder, "rays sorted before shading", false, false},
                      {"rayTracingInvocationReorder", "rays sorted before shading", false, false}};
    return d;
}

// A workstation on which nothing is amiss.
Machine healthy() {
    Machine m;
    m.cpu = {"Fake CPU", 16, "avx2"};
    m.memory = {32ull << 30, 16ull << 30};
    m.loader = {"/usr/lib/libvulkan.so.1", "1.3.239", ""};
    m.manifests = {{"/usr/share/vulkan/icd.d/nvidia_icd.json", "libGLX_nvidia.so.0", true, ""}};
    m.nodes = {{"/dev/dri/renderD128", true}, {"/dev/nvidiactl", true}};
    m.nvidia.kernel_driver = "580.159.04";
    m.devices = {make_device("NVIDIA Fake 3000", false, true)};
    m.denoiser = {"/opt/lib/libOpenImageDenoise.so.2",
                  "Open Image Denoise 2.5.1 on cuda (Fake)",
                  {"cuda (Fake)", "cpu (Fake CPU)"},
                  ""};
    return m;
}

std::string text_of(const Finding& f) {
    return f.subject + ": " + f.text + " -> " + f.advice;
}

// All findings that are to be acted upon, joined.
std::string warnings_of(const Machine& m) {
    std::string all;
    for (const Finding& f : check_all(m))
        if (f.level == Level::warning) all += text_of(f) + "\n";
    return all;
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(Doctor, FindsNothingWrongWithAHealthyMachine) {
    EXPECT_EQ(warnings_of(healthy()), "");
}

TEST(Doctor, TellsOfTheDenoiserAndForgivesItsAbsence) {
    const auto denoiser = [](const Machine& m) {
        for (const Finding& f : check_all(m))
            if (f.subject == "denoiser") return f;
        return Finding{Level::warning, "", ""};
    };
    Machine m = healthy();
    EXPECT_EQ(denoiser(m).level, Level::good);
    EXPECT_EQ(denoiser(m).text,
              "Open Image Denoise 2.5.1 on cuda (Fake), also cpu (Fake CPU) "
              "(/opt/lib/libOpenImageDenoise.so.2)");
    m.denoiser = {"", "", {}, "it is not there; scripts/fetch-oidn.sh gets it"};
    EXPECT_EQ(denoiser(m).level, Level::note);
    EXPECT_TRUE(says(denoiser(m).text, "fetch-oidn.sh"));
    EXPECT_EQ(warnings_of(m), "");
}

TEST(Doctor, EveryWarningSaysWhatToDo) {
    Machine m = healthy();
    m.loader = {"", "", "libvulkan.so.1: cannot open shared object file"};
    m.manifests.clear();
    m.devices.clear();
    m.nodes[0].may_use = false;
    m.memory.available_bytes = 1 << 20;
    for (const bool is_built : {false, true}) {
        m.built_with_vulkan = is_built;
        for (const Finding& f : check_all(m))
            EXPECT_TRUE(f.level != Level::warning || !f.advice.empty()) << text_of(f);
    }
}

TEST(Doctor, NamesThePackageOfAMissingLoader) {
    Machine m = healthy();
    m.loader = {"", "", "libvulkan.so.1: cannot open shared object file"};
    EXPECT_TRUE(says(warnings_of(m), "libvulkan1"));
}

TEST(Doctor, KnowsAContainerWithoutTheGraphicsCapability) {
    Machine m = healthy();
    m.in_container = true;
    m.manifests.clear();
    m.devices.clear();
    m.nvidia.capabilities = "compute,utility";
    const std::string said = warnings_of(m);
    EXPECT_TRUE(says(said, "none is installed")) << said;
    EXPECT_TRUE(says(said, "NVIDIA_DRIVER_CAPABILITIES is \"compute,utility\"")) << said;
    EXPECT_TRUE(says(said, "NVIDIA_DRIVER_CAPABILITIES=all")) << said;
    EXPECT_TRUE(says(said, "libegl1")) << said;
}

TEST(Doctor, NamesThePackageOfALibraryThatADriverMisses) {
    Machine m = healthy();
    m.in_container = true;
    m.devices.clear();
    m.manifests[0].trouble = "libXext.so.6: cannot open shared object file: No such file";
    EXPECT_TRUE(says(warnings_of(m), "Install libxext6"));
    m.manifests[0].trouble = "libEGL.so.1: cannot open shared object file: No such file";
    EXPECT_TRUE(says(warnings_of(m), "Install libegl1"));
    m.manifests[0].trouble = "libGLdispatch.so.0: cannot open shared object file: No such file";
    EXPECT_TRUE(says(warnings_of(m), "Install libglvnd0"));
    m.manifests[0].trouble = "libGLX_nvidia.so.0: cannot open shared object file: No such file";
    EXPECT_TRUE(says(warnings_of(m), "NVIDIA_DRIVER_CAPABILITIES"));
}

// The driver's library opens, but lists no device: a library that it requires is missing.
TEST(Doctor, NamesWhatNvidiasDriverOpensByItself) {
    Machine m = healthy();
    m.nvidia.opened = {
        {"libEGL.so.1", "libegl1", "libEGL.so.1: cannot open shared object file"},
        {"libGLdispatch.so.0", "libglvnd0", ""},
        {"libnvidia-rtcore.so.580.159.04", "", "libnvidia-rtcore.so.580.159.04: cannot open"}};
    EXPECT_EQ(warnings_of(m), "");  // it works all the same
    m.devices = {make_device("llvmpipe", true, true)};
    std::string said = warnings_of(m);
    EXPECT_TRUE(says(said, "it requires libEGL.so.1")) << said;
    EXPECT_TRUE(says(said, "Install libegl1")) << said;
    EXPECT_FALSE(says(said, "libGLdispatch")) << said;
    EXPECT_TRUE(says(said, "-> Reinstall the driver: ray tracing needs")) << said;
    m.in_container = true;
    m.nvidia.capabilities = "compute,graphics,utility";
    said = warnings_of(m);
    EXPECT_TRUE(says(said, "although graphics is requested")) << said;
    EXPECT_FALSE(says(said, "does not have the Vulkan part")) << said;
    m.nvidia.capabilities = "compute,utility";
    EXPECT_TRUE(says(warnings_of(m), "does not have the Vulkan part of the driver"));
}

TEST(Doctor, SeesTwoVersionsOfNvidiasDriver) {
    Machine m = healthy();
    m.nvidia.user_driver = "570.86.10";
    EXPECT_EQ(warnings_of(m), "");
    m.devices.clear();
    EXPECT_TRUE(says(warnings_of(m),
                     "the kernel runs 580.159.04, the library is 570.86.10 -> "
                     "They must have the same version: restart"));
    m.in_container = true;
    EXPECT_TRUE(says(warnings_of(m), "instead of installing one in the image"));
}

TEST(Doctor, KnowsWhichCapabilitiesHaveGraphics) {
    for (const char* some : {"all", "graphics", "compute,graphics,utility"})
        EXPECT_FALSE(lacks_graphics(some)) << some;
    for (const char* none : {"", "compute,utility", "video"})
        EXPECT_TRUE(lacks_graphics(none)) << none;
}

TEST(Doctor, TellsOfAManifestThatOnlyHimalayaFinds) {
    Machine m = healthy();
    m.manifests[0].file = "/usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json";
    m.manifests[0].is_searched = false;
    m.added_drivers = m.manifests[0].file;
    EXPECT_EQ(warnings_of(m), "");
    const auto found = check_all(m);
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), [](const Finding& f) {
        return f.level == Level::note &&
               says(f.text, "export VK_ADD_DRIVER_FILES=/usr/local/nvidia/");
    }));
}

TEST(Doctor, SaysThatAChosenDriverIsNotThere) {
    Machine m = healthy();
    m.chosen_drivers = "/nowhere/icd.json";
    m.manifests = {{"/nowhere/icd.json", "", true, "the manifest names no library"}};
    m.devices.clear();
    m.devices_trouble = "Vulkan: the loader finds no device";
    EXPECT_TRUE(says(warnings_of(m), "none of these can be used -> Unset the variable"));
}

TEST(Doctor, SoftwareAloneIsNoGpu) {
    Machine m = healthy();
    m.nodes.clear();
    m.nvidia.kernel_driver.clear();
    m.devices = {make_device("llvmpipe", true, true)};
    const std::string said = warnings_of(m);
    EXPECT_TRUE(says(said, "no GPU can render")) << said;
    EXPECT_FALSE(says(said, "llvmpipe")) << said;
}

TEST(Doctor, NamesWhatADeviceLacksAndHowToGetIt) {
    Machine m = healthy();
    m.devices = {make_device("NVIDIA Fake 700", false, false)};
    const std::string said = warnings_of(m);
    EXPECT_TRUE(says(said, std::string("lacks ") + kTracing)) << said;
    EXPECT_TRUE(says(said, "Update the driver")) << said;
}

TEST(Doctor, SeesThatVulkanDoesNotShowTheKernelsCard) {
    Machine m = healthy();
    m.devices = {make_device("AMD Fake", false, true)};
    EXPECT_TRUE(says(warnings_of(m), "the kernel has an NVIDIA card"));
}

TEST(Doctor, NamesFilesThatTheUserMayNotUse) {
    Machine m = healthy();
    m.nodes[0].may_use = false;
    EXPECT_TRUE(says(warnings_of(m), "/dev/dri/renderD128 -> Add the user to the groups"));
    m.in_container = true;
    EXPECT_TRUE(says(warnings_of(m), "--group-add"));
}

TEST(Doctor, SaysThatABuildLeavesVulkanOut) {
    Machine m = healthy();
    m.built_with_vulkan = false;
    m.devices.clear();
    m.devices_trouble = "this build leaves the Vulkan renderer out";
    EXPECT_TRUE(says(warnings_of(m), "HIMALAYA_VULKAN=ON"));
}

TEST(Doctor, FeaturesComeOncePerPurposeWithAllThatIsMissing) {
    const auto tiers = tiers_of(make_device("llvmpipe", true, true));
    ASSERT_EQ(tiers.size(), 2u);
    EXPECT_EQ(tiers[0].feature, "path tracing");
    EXPECT_TRUE(tiers[0].missing.empty());
    EXPECT_EQ(tiers[1].feature, "rays sorted before shading");
    EXPECT_EQ(tiers[1].missing,
              (std::vector<std::string>{kReorder, "rayTracingInvocationReorder"}));
}

}  // namespace
}  // namespace hm::cli
