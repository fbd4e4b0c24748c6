// Compiled pipelines kept between runs: a file per device and driver under the user's cache folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "rhi/device.h"

namespace hm::rhi {

// $XDG_CACHE_HOME/himalaya or ~/.cache/himalaya; empty where neither variable is set.
std::filesystem::path default_cache_folder();

class PipelineCache {
  public:
    // An empty folder keeps nothing between runs. A file that is damaged or another driver's is a
    // warning, and the cache starts empty.
    static Result<PipelineCache> open(Device& device, const std::filesystem::path& folder,
                                      Diagnostics& diagnostics);
    // Writes the file if there is something new in it. Fails with ErrorKind::unwritable.
    Result<void> save();

    const std::filesystem::path& file() const { return file_; }
    std::size_t loaded_bytes() const { return loaded_bytes_; }
    VkPipelineCache handle() const { return handle_.get(); }

  private:
    Device* device_ = nullptr;
    std::filesystem::path file_;
    std::size_t loaded_bytes_ = 0;
    std::uint64_t saved_hash_ = 0;  // of what the file holds
    Handle<VkPipelineCache, &vkDestroyPipelineCache> handle_;
};

}  // namespace hm::rhi
