// What a Vulkan device must offer to run the path tracer, what it may offer, and which of that a
// given device has: the report behind device choice, `himalaya doctor` and error messages.
//
// judge() is plain data to plain data, so the tests feed it devices that do not exist.
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
    bool computes = false;             // it has a queue for that
    bool timestamps = false;           // on that queue
};

struct Capability {
    std::string name;     // an extension, a feature, or one of those above
    std::string purpose;  // what for, in a few words
    bool required = true;
    bool present = false;
};

// All capabilities that we ask for, in a fixed order, and whether `offer` has them.
std::vector<Capability> judge(const Offer& offer);

// Names of the required ones that are missing.
std::vector<std::string> missing(const std::vector<Capability>& capabilities);

}  // namespace hm::rhi
