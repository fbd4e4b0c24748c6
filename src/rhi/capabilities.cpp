#include "rhi/capabilities.h"

#include <algorithm>

#include "rhi/features.h"

namespace hm::rhi {

std::vector<Capability> judge(const Offer& offer) {
    std::vector<Capability> all;
    all.push_back({kVulkan13, "the version this is written for", true,
                   offer.api_version >= VK_API_VERSION_1_3});
    all.push_back({kComputeQueue, "running anything at all", true, offer.computes});
    for (const Extension& extension : all_extensions())
        all.push_back({extension.name, extension.purpose, extension.required,
                       offer.extensions.contains(extension.name)});
    for (const Feature& feature : all_features())
        all.push_back({feature.name, feature.purpose, feature.required,
                       offer.features.contains(feature.name)});
    all.push_back({kRayQuery, "rays from any shader: nothing needs it yet, previews may", false,
                   offer.extensions.contains(kRayQuery)});
    all.push_back({kTimestamps, "timing what the device does", false, offer.timestamps});
    return all;
}

std::vector<std::string> missing(const std::vector<Capability>& capabilities) {
    std::vector<std::string> names;
    for (const Capability& capability : capabilities)
        if (capability.required && !capability.present) names.push_back(capability.name);
    return names;
}

}  // namespace hm::rhi
