// Persistent cache of compiled pipelines: a file per device and driver in the user's cache folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "rhi/device.h"

namespace hm::rhi {

// $XDG_CACHE_HOME/himalaya or ~/.cache/himalaya; empty if neither $XDG_CACHE_HOME nor $HOME is set.
std::filesystem::path default_cache_folder();

class PipelineCache {
  public:
    // With an empty folder nothing is stored between runs. A file that is damaged or from another
    // driver gives a warning, and the cache starts empty.
    static Result<PipelineCache> open(Device& device, const std::filesystem::path& folder,
                                      Diagnostics& diagnostics);
    // Writes the file if the cache has changed. Fails with ErrorKind::unwritable.
    Result<void> save();

    const std::filesystem::path& file() const { return file_; }
    std::size_t loaded_bytes() const { return loaded_bytes_; }
    VkPipelineCache handle() const { return handle_.get(); }

  private:
    Device* device_ = nullptr;
    std::filesystem::path file_;
    std::size_t loaded_bytes_ = 0;
    std::uint64_t saved_hash_ = 0;  // of the file's contents
    Handle<VkPipelineCache, &vkDestroyPipelineCache> handle_;
};

}  // namespace hm::rhi
