// Device selection among fake devices, and the errors on machines without Vulkan.
#include "rhi/capabilities.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "rhi/error.h"
#include "rhi/features.h"
#include "rhi/instance.h"
#include "rhi/physical_device.h"

namespace hm::rhi {
namespace {

Offer everything() {
    Offer offer;
    offer.api_version = VK_API_VERSION_1_3;
    for (const Extension& extension : all_extensions())
        offer.extensions.insert(extension.name);
    for (const Feature& feature : all_features())
        offer.features.insert(feature.name);
    offer.computes = true;
    offer.timestamps = true;
    return offer;
}

PhysicalDevice device(std::uint32_t index, std::string name, DeviceKind kind,
                      std::uint64_t memory_bytes, const Offer& offer) {
    PhysicalDevice device;
    device.index = index;
    device.name = std::move(name);
    device.kind = kind;
    device.memory_bytes = memory_bytes;
    device.capabilities = judge(offer);
    return device;
}

using Names = std::vector<std::string>;

TEST(Capabilities, NothingIsMissingWhereEverythingIsThere) {
    EXPECT_EQ(missing(judge(everything())), Names{});
}

TEST(Capabilities, WhatIsMissingIsNamed) {
    Offer offer = everything();
    offer.api_version = VK_API_VERSION_1_2;
    offer.extensions.erase("VK_KHR_ray_tracing_pipeline");
    offer.features.erase("scalarBlockLayout");
    EXPECT_EQ(missing(judge(offer)),
              (Names{"Vulkan 1.3", "VK_KHR_ray_tracing_pipeline", "scalarBlockLayout"}));
}

TEST(Capabilities, OptionalOnesMayBeMissing) {
    Offer offer = everything();
    offer.extensions.erase("VK_NV_ray_tracing_invocation_reorder");
    offer.features.erase("rayTracingInvocationReorder");
    offer.extensions.erase("VK_EXT_memory_budget");
    offer.timestamps = false;
    EXPECT_EQ(missing(judge(offer)), Names{});
    const PhysicalDevice made = device(0, "x", DeviceKind::discrete, 1, offer);
    EXPECT_FALSE(made.has("timestamps"));
    EXPECT_FALSE(made.has("VK_EXT_memory_budget"));
    EXPECT_TRUE(made.has("VK_KHR_push_descriptor"));
    EXPECT_FALSE(made.has("no such thing"));
}

TEST(DeviceChoice, ACardWithMoreMemoryIsBest) {
    const std::vector<PhysicalDevice> devices = {
        device(0, "software", DeviceKind::cpu, 1000, everything()),
        device(1, "integrated", DeviceKind::integrated, 900, everything()),
        device(2, "small card", DeviceKind::discrete, 10, everything()),
        device(3, "large card", DeviceKind::discrete, 20, everything()),
        device(4, "largest card, old driver", DeviceKind::discrete, 30, Offer{})};
    EXPECT_EQ(choose_best(devices)->name, "large card");
    EXPECT_EQ(choose_best(std::span(devices).first(2))->name, "integrated");
}

TEST(DeviceChoice, SoftwareServesOnlyWhenNamed) {
    Offer old = everything();
    old.extensions.erase("VK_KHR_acceleration_structure");
    const std::vector<PhysicalDevice> devices = {
        device(0, "old card", DeviceKind::discrete, 10, old),
        device(1, "llvmpipe", DeviceKind::cpu, 10, everything())};
    const Result<PhysicalDevice> best = choose_best(devices);
    ASSERT_FALSE(best.has_value());
    EXPECT_EQ(best.error().kind, ErrorKind::no_device);
    EXPECT_EQ(best.error().line(),
              "Vulkan: no device serves: vulkan:0 (old card) lacks VK_KHR_acceleration_structure; "
              "vulkan:1 (llvmpipe) runs on the CPU, and only serves when it is named");
    EXPECT_EQ(choose_index(devices, 1)->name, "llvmpipe");
}

TEST(DeviceChoice, AWrongIndexListsWhatThereIs) {
    const std::vector<PhysicalDevice> devices = {
        device(0, "card", DeviceKind::discrete, 10, everything())};
    const Result<PhysicalDevice> chosen = choose_index(devices, 3);
    ASSERT_FALSE(chosen.has_value());
    EXPECT_EQ(chosen.error().line(), "Vulkan: there is no vulkan:3, only vulkan:0 (card)");
    EXPECT_EQ(choose_index({}, 0).error().message, kNoDevices);
    EXPECT_EQ(choose_best({}).error().message, kNoDevices);
}

TEST(Instance, AMissingLoaderIsNamed) {
    const Result<std::shared_ptr<Instance>> instance =
        Instance::create({.validation = false, .loader = "libno-such-vulkan.so.1"});
    ASSERT_FALSE(instance.has_value());
    EXPECT_EQ(instance.error().kind, ErrorKind::no_device);
    EXPECT_NE(instance.error().line().find("libno-such-vulkan.so.1"), std::string::npos);
    EXPECT_NE(instance.error().line().find("libvulkan1"), std::string::npos);
}

TEST(Instance, ALibraryThatIsNoLoaderIsNamed) {
    const Result<std::shared_ptr<Instance>> instance =
        Instance::create({.validation = false, .loader = "libm.so.6"});
    ASSERT_FALSE(instance.has_value());
    EXPECT_EQ(instance.error().line(), "Vulkan: libm.so.6 is not a Vulkan loader");
}

TEST(Errors, SayTheResultAndTheObject) {
    const Error lost = device_error(VK_ERROR_DEVICE_LOST, "vkQueueSubmit2", "trace");
    EXPECT_EQ(lost.kind, ErrorKind::device_failed);
    EXPECT_EQ(lost.line().find("Vulkan: trace: vkQueueSubmit2 returned VK_ERROR_DEVICE_LOST; "), 0u)
        << lost.line();
    EXPECT_EQ(device_error(VK_ERROR_FEATURE_NOT_PRESENT, "vkCreateDevice", "x").kind,
              ErrorKind::no_device);
    EXPECT_EQ(result_name(static_cast<VkResult>(-77)), "VkResult -77");
    EXPECT_TRUE(check(VK_TIMEOUT, "vkWaitSemaphores", "").has_value());
}

}  // namespace
}  // namespace hm::rhi
