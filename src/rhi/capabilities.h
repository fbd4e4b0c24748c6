// The required and optional capabilities of a Vulkan device for the path tracer, and which of them
// a given device has: the basis of device selection, `himalaya doctor` and error messages.
//
// judge() maps plain data to plain data, so the tests can pass it fake devices.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace hm::rhi {

inline constexpr const char* kVulkan13 = "Vulkan 1.3";
inline constexpr const char* kComputeQueue = "a queue that computes";
inline constexpr const char* kTimestamps = "timestamps";
inline constexpr const char* kInvocationReorder = "rayTracingInvocationReorder";
inline constexpr const char* kRayQuery = "VK_KHR_ray_query";  // reported, not enabled

// What a device reports, by Vulkan's own names.
struct Offer {
    std::uint32_t api_version = 0;     // VK_MAKE_API_VERSION's encoding
    std::set<std::string> extensions;  // "VK_KHR_ray_tracing_pipeline"
    std::set<std::string> features;    // "scalarBlockLayout"
    bool computes = false;             // has a compute queue
    bool timestamps = false;           // supported on that queue
};

struct Capability {
    std::string name;     // an extension, a feature, or one of those above
    std::string purpose;  // what it is needed for, in a few words
    bool required = true;
    bool present = false;
};

// All capabilities that we query, in a fixed order, and whether `offer` has them.
std::vector<Capability> judge(const Offer& offer);

// Names of the required ones that are missing.
std::vector<std::string> missing(const std::vector<Capability>& capabilities);

}  // namespace hm::rhi
