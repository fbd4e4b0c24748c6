// Devices, memory, copies and their errors, on a real device under validation.
#include "rhi/device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "rhi/buffer.h"
#include "rhi/commands.h"
#include "rhi/image.h"
#include "rhi/query.h"
#include "rhi/test_device.h"
#include "rhi/upload.h"

namespace hm::rhi {
namespace {

using test::expect_ok;
using test::value_of;

class RhiDevice : public test::DeviceTest {};

std::vector<std::uint32_t> counting(std::size_t count, std::uint32_t first = 0) {
    std::vector<std::uint32_t> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

TEST_F(RhiDevice, DescribesItself) {
    const PhysicalDevice& physical = device().physical();
    EXPECT_FALSE(physical.name.empty());
    EXPECT_TRUE(physical.usable());
    EXPECT_GT(physical.memory_bytes, 0u);
    EXPECT_GE(physical.limits.max_textures, 1000u);
    EXPECT_GE(physical.limits.max_recursion_depth, 1u);
    const MemoryUse use = device().memory_use();
    EXPECT_GT(use.budget_bytes, use.used_bytes);
}

TEST_F(RhiDevice, ValidationIsHeard) {
    if (!instance().validates()) GTEST_SKIP() << "HIMALAYA_VALIDATION is 0";
    // A copy out of a buffer's bounds: the layer must report it, otherwise the other tests would be
    // meaningless. It does so while recording; the copy is never executed.
    const Buffer a = value_of(Buffer::create(device(), {.name = "small buffer", .size = 16}));
    const Commands commands = value_of(Commands::begin(device(), "bad copy"));
    const VkBufferCopy region{8, 0, 16};
    vkCmdCopyBuffer(commands.handle(), a.handle(), a.handle(), 1, &region);
    const std::vector<Message> messages = instance().messages().take();
    ASSERT_FALSE(messages.empty());
    EXPECT_TRUE(messages.front().error);
    EXPECT_NE(messages.front().text.find("small buffer"), std::string::npos)
        << messages.front().line();
}

TEST(RhiInstance, PrintsMessagesThatNobodyTook) {
    ::testing::internal::CaptureStderr();
    {
        const auto instance = value_of(Instance::create({.validation = false}));
        instance->messages().add({.error = true, .id = "VUID-x", .text = "something"});
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(),
              "himalaya: Vulkan validation: error: VUID-x: something\n");
}

TEST_F(RhiDevice, SynchronisationValidationIsHeard) {
    if (!instance().validates()) GTEST_SKIP() << "HIMALAYA_VALIDATION is 0";
    const Buffer a = value_of(Buffer::create(device(), {.name = "a", .size = 16}));
    expect_ok(run_once(device(), "race", [&](Commands& commands) -> Result<void> {
        commands.fill(a, 1);
        commands.fill(a, 2);
        return {};
    }));
    const std::vector<Message> messages = instance().messages().take();
    ASSERT_FALSE(messages.empty());
    EXPECT_NE(messages.front().line().find("WRITE_AFTER_WRITE"), std::string::npos)
        << messages.front().line();
}

TEST_F(RhiDevice, BuffersKeepWhatIsUploaded) {
    const std::vector<std::uint32_t> values = counting(1000);
    const Buffer buffer = value_of(Buffer::create(device(), {.name = "values", .size = 4000}));
    EXPECT_NE(buffer.address(), 0u);
    EXPECT_TRUE(buffer.mapped().empty());
    Uploader uploader = value_of(Uploader::create(device(), 1 << 16));
    expect_ok(uploader.buffer(buffer, std::span(values)));
    expect_ok(uploader.finish());
    std::vector<std::uint32_t> back(1000);
    expect_ok(read_back(device(), buffer, std::as_writable_bytes(std::span(back))));
    EXPECT_EQ(back, values);
    std::vector<std::uint32_t> part(10);
    expect_ok(read_back(device(), buffer, std::as_writable_bytes(std::span(part)), 400));
    EXPECT_EQ(part, counting(10, 100));
}

// Uploads 100 kB through 1 kB of staging in pieces that do not divide it, then a part again.
TEST_F(RhiDevice, LargeUploadsGoInChunks) {
    const std::vector<std::uint32_t> values = counting(25'000);
    const Buffer buffer =
        value_of(Buffer::create(device(), {.name = "values", .size = values.size() * 4}));
    Uploader uploader = value_of(Uploader::create(device(), 1000));
    const auto all = std::as_bytes(std::span(values));
    for (std::size_t begin = 0; begin < all.size(); begin += 7777)
        expect_ok(uploader.buffer(
            buffer, all.subspan(begin, std::min<std::size_t>(7777, all.size() - begin)), begin));
    EXPECT_EQ(uploader.bytes(), all.size());
    const std::vector<std::uint32_t> again(500, 7u);
    expect_ok(uploader.buffer(buffer, std::as_bytes(std::span(again)), 40));
    expect_ok(uploader.finish());
    std::vector<std::uint32_t> expected = values;
    std::ranges::copy(again, expected.begin() + 10);
    std::vector<std::uint32_t> back(values.size());
    expect_ok(read_back(device(), buffer, std::as_writable_bytes(std::span(back))));
    EXPECT_EQ(back, expected);
}

TEST_F(RhiDevice, ImagesKeepWhatIsUploaded) {
    // 37 x 21 texels, 148 bytes per row: 1000 bytes of staging hold six rows at a time.
    const std::vector<std::uint32_t> texels = counting(37 * 21);
    const Image image = value_of(Image::create(
        device(),
        {.name = "picture", .format = Format::rgba8, .width = 37, .height = 21, .levels = 2}));
    Uploader uploader = value_of(Uploader::create(device(), 1000));
    expect_ok(uploader.image(image, 0, std::as_bytes(std::span(texels))));
    const std::vector<std::uint32_t> half(18 * 10, 5u);
    expect_ok(uploader.image(image, 1, std::as_bytes(std::span(half))));
    expect_ok(uploader.finish());
    expect_ok(run_once(device(), "layout", [&](Commands& commands) -> Result<void> {
        commands.transition(image, ImageLayout::shader_read, ImageLayout::transfer_source);
        return {};
    }));
    std::vector<std::uint32_t> back(texels.size());
    expect_ok(read_back(device(), image, ImageLayout::transfer_source,
                        std::as_writable_bytes(std::span(back))));
    EXPECT_EQ(back, texels);
}

TEST_F(RhiDevice, ImagesAreCleared) {
    const Image image = value_of(Image::create(device(), {.name = "sums",
                                                          .format = Format::rgba32f,
                                                          .width = 8,
                                                          .height = 4,
                                                          .use = ImageUse::storage}));
    expect_ok(run_once(device(), "clear", [&](Commands& commands) -> Result<void> {
        commands.transition(image, ImageLayout::undefined, ImageLayout::general);
        commands.clear(image, ImageLayout::general, 0.25f);
        return {};
    }));
    std::vector<float> back(8 * 4 * 4);
    expect_ok(
        read_back(device(), image, ImageLayout::general, std::as_writable_bytes(std::span(back))));
    EXPECT_EQ(back, std::vector<float>(back.size(), 0.25f));
}

TEST_F(RhiDevice, SubmissionsAreTickets) {
    const Buffer buffer = value_of(
        Buffer::create(device(), {.name = "counter", .size = 4, .memory = MemoryKind::readback}));
    Commands commands = value_of(Commands::begin(device(), "first"));
    commands.fill(buffer, 1);
    const Ticket first = value_of(device().submit(commands));
    expect_ok(device().wait(first));
    EXPECT_TRUE(value_of(device().reached(first)));
    EXPECT_FALSE(value_of(device().reached(first + 1)));
    expect_ok(commands.begin_again());
    commands.fill(buffer, 2);
    const Ticket second = value_of(device().submit(commands));
    EXPECT_GT(second, first);
    expect_ok(device().wait(second));
    EXPECT_EQ(*reinterpret_cast<const std::uint32_t*>(buffer.mapped().data()), 2u);
}

TEST_F(RhiDevice, TimestampsRise) {
    if (!device().physical().has(kTimestamps)) GTEST_SKIP() << "no timestamps here";
    const Buffer buffer = value_of(Buffer::create(device(), {.name = "filled", .size = 1 << 20}));
    Timestamps times = value_of(Timestamps::create(device(), "times", 3));
    expect_ok(run_once(device(), "timed", [&](Commands& commands) -> Result<void> {
        times.reset(commands);
        times.write(commands, 0);
        commands.fill(buffer, 1);
        times.write(commands, 1);
        commands.full_barrier();
        commands.fill(buffer, 2);
        times.write(commands, 2);
        return {};
    }));
    const std::vector<double> ms = value_of(times.milliseconds(3));
    EXPECT_EQ(ms[0], 0.0);
    EXPECT_GE(ms[1], 0.0);
    EXPECT_GT(ms[2], ms[1]);
}

TEST_F(RhiDevice, OutOfMemorySaysHowMuch) {
    const Result<Buffer> buffer =
        Buffer::create(device(), {.name = "a very large scene", .size = std::uint64_t{1} << 50});
    ASSERT_FALSE(buffer.has_value());
    EXPECT_EQ(buffer.error().kind, ErrorKind::device_failed);
    const std::string line = buffer.error().line();
    for (const char* part : {"a very large scene", "VK_ERROR_OUT_OF_DEVICE_MEMORY",
                             "1 PiB were requested", "are in use"})
        EXPECT_NE(line.find(part), std::string::npos) << line;
}

// Allocation fails when device memory is exhausted; there is no silent fallback to host memory.
TEST_F(RhiDevice, MoreThanIsFreeIsRefused) {
    const std::uint64_t bytes = device().memory_use().budget_bytes + (std::uint64_t{1} << 30);
    const Result<Buffer> buffer = Buffer::create(device(), {.name = "scene", .size = bytes});
    ASSERT_FALSE(buffer.has_value());
    EXPECT_NE(buffer.error().line().find("VK_ERROR_OUT_OF_DEVICE_MEMORY"), std::string::npos)
        << buffer.error().line();
    EXPECT_TRUE(Buffer::create(device(), {.name = "small", .size = 1 << 20}).has_value());
}

TEST_F(RhiDevice, ImagesTooLargeAreRefused) {
    const Result<Image> image = Image::create(
        device(), {.name = "poster", .format = Format::rgba8, .width = 1 << 20, .height = 4});
    ASSERT_FALSE(image.has_value());
    EXPECT_EQ(image.error().line().find("Vulkan: poster: an image of 1048576 x 4"), 0u)
        << image.error().line();
}

TEST_F(RhiDevice, ADeviceThatLacksSomethingIsNotMade) {
    PhysicalDevice physical = device().physical();
    for (Capability& capability : physical.capabilities)
        if (capability.name == "scalarBlockLayout") capability.present = false;
    const Result<std::unique_ptr<Device>> made =
        Device::create(value_of(Instance::create({.validation = false})), physical);
    ASSERT_FALSE(made.has_value());
    EXPECT_EQ(made.error().kind, ErrorKind::no_device);
    EXPECT_EQ(made.error().line(), "Vulkan: " + physical.name + ": lacks scalarBlockLayout");
}

TEST(RhiInstance, NoDriverIsNamed) {
    const test::Variable only("VK_DRIVER_FILES", "/nonexistent/icd.json");
    const test::Variable none("VK_ADD_DRIVER_FILES", nullptr);
    const Result<std::shared_ptr<Instance>> instance = Instance::create({.validation = false});
    const Result<std::vector<PhysicalDevice>> devices =
        instance ? (*instance)->devices() : std::vector<PhysicalDevice>{};
    if (instance) {
        EXPECT_TRUE(value_of(devices).empty());
    } else {
        EXPECT_EQ(instance.error().kind, ErrorKind::no_device);
        EXPECT_EQ(instance.error().message, kNoDevices);
    }
}

}  // namespace
}  // namespace hm::rhi
