// Descriptors, compute pipelines and the pipeline cache, on a real device under validation.
#include "rhi/pipeline.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/files.h"
#include "rhi/commands.h"
#include "rhi/pipeline_cache.h"
#include "rhi/test_device.h"
#include "rhi/upload.h"
#include "shaders/scale_comp.h"

namespace hm::rhi {
namespace {

namespace fs = std::filesystem;
using test::expect_ok;
using test::value_of;

constexpr std::uint32_t kSlots = 64;

class RhiPipeline : public test::DeviceTest {
  protected:
    void SetUp() override {
        DeviceTest::SetUp();
        folder_ = fs::temp_directory_path() /
                  ("himalaya-cache-" + std::to_string(::getpid()) + "-" +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
    }
    void TearDown() override {
        DeviceTest::TearDown();
        fs::remove_all(folder_);
    }
    const fs::path& folder() const { return folder_; }

  private:
    fs::path folder_;
};

// The shader scale.comp with its layouts: push constants, and a bindless texture table with mostly
// empty slots.
struct Scale {
    SetLayout values, textures;
    PipelineLayout layout;
    ComputePipeline pipeline;

    Scale(Device& device, PipelineCache* cache) {
        const Binding buffer{.binding = 0};
        values = value_of(SetLayout::create(device, "values", std::span(&buffer, 1), true));
        const Binding table{
            .binding = 0, .kind = DescriptorKind::texture, .count = kSlots, .bindless = true};
        textures = value_of(SetLayout::create(device, "textures", std::span(&table, 1)));
        const std::array<const SetLayout*, 2> sets{&values, &textures};
        layout = value_of(PipelineLayout::create(device, "scale", sets, 12));
        pipeline = value_of(
            ComputePipeline::create(device, "scale", layout, shaders::scale_comp(), cache));
    }
};

TEST_F(RhiPipeline, DispatchesWithPushedAndBindlessDescriptors) {
    const Scale scale(device(), nullptr);
    Uploader uploader = value_of(Uploader::create(device(), 1 << 16));
    const std::vector<std::uint32_t> values = {1, 2, 3, 4, 5, 6, 7, 8};
    const Buffer buffer = value_of(upload_buffer(uploader, device(), {.name = "values", .size = 32},
                                                 std::as_bytes(std::span(values))));
    const Image image = value_of(
        Image::create(device(), {.name = "ramp", .format = Format::r8, .width = 8, .height = 1}));
    const std::vector<std::uint8_t> ramp = {0, 10, 20, 30, 40, 50, 60, 255};
    expect_ok(uploader.image(image, 0, std::as_bytes(std::span(ramp))));
    expect_ok(uploader.finish());
    const Sampler sampler = value_of(Sampler::create(device(), {.name = "nearest"}));
    DescriptorSet table = value_of(DescriptorSet::create(device(), "textures", scale.textures));

    expect_ok(run_once(device(), "scale", [&](Commands& commands) -> Result<void> {
        commands.begin_label("scaling");
        commands.bind(scale.pipeline);
        commands.push_set(scale.layout, 0, DescriptorWrites(scale.values).buffer(0, buffer));
        commands.bind_set(scale.layout, 1, table);
        // Written after the set was bound, to a slot after others that stay empty.
        table.update(DescriptorWrites(scale.textures).texture(0, image, sampler, 41));
        commands.push_constants(scale.layout, std::array<std::uint32_t, 3>{3, 41, 8});
        commands.dispatch(1);
        commands.end_label();
        return {};
    }));
    std::vector<std::uint32_t> back(8);
    expect_ok(read_back(device(), buffer, std::as_writable_bytes(std::span(back))));
    EXPECT_EQ(back, (std::vector<std::uint32_t>{3, 16, 29, 42, 55, 68, 81, 279}));
}

TEST_F(RhiPipeline, TheCacheIsKeptBetweenRuns) {
    Diagnostics diagnostics;
    fs::path file;
    {
        PipelineCache cache = value_of(PipelineCache::open(device(), folder(), diagnostics));
        EXPECT_EQ(cache.loaded_bytes(), 0u);
        const Scale scale(device(), &cache);
        expect_ok(cache.save());
        file = cache.file();
        ASSERT_TRUE(fs::exists(file));
    }
    PipelineCache cache = value_of(PipelineCache::open(device(), folder(), diagnostics));
    EXPECT_GT(cache.loaded_bytes(), 0u);
    const Scale scale(device(), &cache);
    // If the cache has not changed, nothing is written.
    fs::remove(file);
    expect_ok(cache.save());
    EXPECT_TRUE(diagnostics.warnings().empty());
}

TEST_F(RhiPipeline, ADamagedCacheIsAWarningAndWrittenAnew) {
    Diagnostics diagnostics;
    PipelineCache first = value_of(PipelineCache::open(device(), folder(), diagnostics));
    const Scale scale(device(), &first);
    expect_ok(first.save());
    ByteArray bytes = value_of(read_file(first.file()));
    bytes.back() ^= std::byte{1};
    expect_ok(write_file_atomically(first.file(), bytes));

    PipelineCache second = value_of(PipelineCache::open(device(), folder(), diagnostics));
    EXPECT_EQ(second.loaded_bytes(), 0u);
    ASSERT_EQ(diagnostics.warnings().size(), 1u);
    EXPECT_NE(diagnostics.warnings()[0].line().find("is damaged"), std::string::npos);
    const Scale again(device(), &second);
    expect_ok(second.save());
    PipelineCache third = value_of(PipelineCache::open(device(), folder(), diagnostics));
    EXPECT_GT(third.loaded_bytes(), 0u);
    EXPECT_EQ(diagnostics.warnings().size(), 1u);
}

TEST_F(RhiPipeline, ACacheThatCannotBeWrittenIsAnError) {
    Diagnostics diagnostics;
    std::ofstream(folder()) << "a file where the folder should be";
    PipelineCache cache = value_of(PipelineCache::open(device(), folder(), diagnostics));
    const Scale scale(device(), &cache);
    const Result<void> saved = cache.save();
    ASSERT_FALSE(saved.has_value());
    EXPECT_EQ(saved.error().kind, ErrorKind::unwritable);
}

TEST(RhiPipelineCache, FollowsTheUsersCacheFolder) {
    const test::Variable home("HOME", "/home/somebody");
    {
        const test::Variable cache("XDG_CACHE_HOME", "/elsewhere");
        EXPECT_EQ(default_cache_folder(), fs::path("/elsewhere/himalaya"));
    }
    // The specification says to ignore it.
    const test::Variable cache("XDG_CACHE_HOME", "relative");
    EXPECT_EQ(default_cache_folder(), fs::path("/home/somebody/.cache/himalaya"));
    const test::Variable homeless("HOME", nullptr);
    EXPECT_EQ(default_cache_folder(), fs::path());
}

}  // namespace
}  // namespace hm::rhi
