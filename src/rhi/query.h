// GPU timestamps.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "rhi/commands.h"
#include "rhi/device.h"

namespace hm::rhi {

class Timestamps {
  public:
    Timestamps() = default;
    static Result<Timestamps> create(Device& device, std::string_view name, std::uint32_t count);

    // Resets all timestamps; required before the first write of a recording.
    void reset(Commands& commands);
    // Writes the time when all work recorded before has finished.
    void write(Commands& commands, std::uint32_t index);
    // Milliseconds since write 0 for each of the first `count`, whose commands must be complete.
    // All 0 on a device without timestamps.
    Result<std::vector<double>> milliseconds(std::uint32_t count) const;

  private:
    Device* device_ = nullptr;
    Handle<VkQueryPool, &vkDestroyQueryPool> pool_;
    std::uint32_t count_ = 0;
};

}  // namespace hm::rhi
