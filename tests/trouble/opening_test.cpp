// Creates a device and compiles its pipelines, once for each Vulkan call that may fail.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "gpu/context.h"
#include "rhi/test_device.h"
#include "trouble/sweep.h"

namespace hm::test {
namespace {

namespace fs = std::filesystem;

class Opening : public testing::Test {
  protected:
    static void SetUpTestSuite() { enable_trouble_layer(); }

    void SetUp() override {
        index_ = rhi::test::any_device(*rhi::test::make_instance()).index;
        folder_ = fs::path(testing::TempDir()) / "trouble_opening";
        fs::remove_all(folder_);
    }
    void TearDown() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    // What the program does before it loads a scene, and compiling. The instance is left for its
    // messages.
    Result<void> open(std::shared_ptr<rhi::Instance>& instance, Diagnostics& diagnostics) {
        HM_TRY_ASSIGN(instance, rhi::Instance::create({.validation = rhi::test::validates()}));
        HM_TRY_ASSIGN(const std::vector<rhi::PhysicalDevice> all, instance->devices());
        HM_TRY_ASSIGN(const rhi::PhysicalDevice physical, rhi::choose_index(all, index_));
        HM_TRY_ASSIGN(std::unique_ptr<rhi::Device> device, rhi::Device::create(instance, physical));
        HM_TRY_ASSIGN(const std::unique_ptr<GpuContext> context,
                      GpuContext::create(std::move(device), folder_, diagnostics));
        HM_TRY(context->bare_trace());
        if (compiles_all_) HM_TRY(context->path_tracing({}));
        return {};
    }

    void sweep_opening(VkResult result) {
        const auto attempt = [&]() -> std::optional<Error> {
            std::shared_ptr<rhi::Instance> instance;
            Diagnostics diagnostics;
            const Result<void> opened = open(instance, diagnostics);
            if (instance)
                for (const rhi::Message& message : instance->messages().take())
                    ADD_FAILURE() << message.line();
            if (!opened) return opened.error();
            return std::nullopt;
        };
        // These fail without harm.
        const std::set<std::string> kHarmless = {"vkDeviceWaitIdle", "vkWaitSemaphores",
                                                 "vkGetPipelineCacheData"};
        sweep(result, attempt, [&](const std::string& function, const std::optional<Error>& error) {
            if (error) expect_named(*error, result);
            EXPECT_TRUE(error || kHarmless.contains(function));
        });
    }

    std::uint32_t index_ = 0;
    fs::path folder_;
    bool compiles_all_ = false;  // also the path tracer, which is slow
};

TEST_F(Opening, OutOfDeviceMemoryHasAName) {
    compiles_all_ = true;
    sweep_opening(VK_ERROR_OUT_OF_DEVICE_MEMORY);
}

TEST_F(Opening, OutOfHostMemoryHasAName) {
    sweep_opening(VK_ERROR_OUT_OF_HOST_MEMORY);
}

TEST_F(Opening, ALostDeviceHasAName) {
    sweep_opening(VK_ERROR_DEVICE_LOST);
}

TEST_F(Opening, ADriverThatKeepsNoNamesIsGoodEnough) {
    trouble::arm(VK_ERROR_OUT_OF_HOST_MEMORY, 0, "vkSetDebugUtilsObjectNameEXT");
    std::shared_ptr<rhi::Instance> instance;
    Diagnostics diagnostics;
    rhi::test::expect_ok(open(instance, diagnostics));
    EXPECT_EQ(trouble::hit(), "vkSetDebugUtilsObjectNameEXT");
    trouble::disarm();
}

TEST_F(Opening, PipelinesThatCannotBeKeptAreAWarning) {
    folder_ = "/proc/nowhere";
    std::shared_ptr<rhi::Instance> instance;
    Diagnostics diagnostics;
    rhi::test::expect_ok(open(instance, diagnostics));
    ASSERT_EQ(diagnostics.warnings().size(), 1u);
    EXPECT_TRUE(diagnostics.warnings()[0].line().starts_with(
        "/proc/nowhere: compiled pipelines can't be kept"))
        << diagnostics.warnings()[0].line();
}

// A sweep would silently leave out a call that it does not know.
TEST(Sweep, KnowsEveryCallWhoseResultIsLookedAt) {
    std::set<std::string> known;
    for (const std::string& name : trouble::functions())
        known.insert(name);
    known.insert("vkCreateDebugUtilsMessengerEXT");  // validation's, for tests alone
    const std::regex call(R"(check\(\s*(vk[A-Z]\w+))");
    int found = 0;
    for (const char* room : {"rhi", "graph", "gpu"}) {
        const fs::path folder = fs::path(std::getenv("HIMALAYA_SOURCE_DIR")) / "src" / room;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".cpp") continue;
            std::ifstream file(entry.path());
            const std::string text(std::istreambuf_iterator<char>(file), {});
            for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
                ++found;
                EXPECT_TRUE(known.contains((*it)[1])) << entry.path() << ": " << (*it)[1];
            }
        }
    }
    EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace hm::test
