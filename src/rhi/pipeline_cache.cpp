#include "rhi/pipeline_cache.h"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <vector>

#include "base/files.h"
#include "rhi/error.h"

namespace hm::rhi {

namespace {

namespace fs = std::filesystem;

// The header before the driver's data, used to validate it: drivers validate little of their input,
// and some crash on damaged data.
struct FileHeader {
    char magic[8] = {'h', 'm', 'p', 'i', 'p', 'e', 's', '1'};
    std::uint64_t bytes = 0;
    std::uint64_t hash = 0;
};

// FNV-1a.
std::uint64_t hash_of(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const std::byte byte : bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
    return hash;
}

std::string hex(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes)
        text += fmt::format("{:02x}", byte);
    return text;
}

// The driver's part of a file; empty if it is damaged.
std::span<const std::byte> contents(std::span<const std::byte> file) {
    FileHeader header;
    const FileHeader expected;
    if (file.size() < sizeof(header)) return {};
    std::memcpy(&header, file.data(), sizeof(header));
    file = file.subspan(sizeof(header));
    if (std::memcmp(header.magic, expected.magic, sizeof(header.magic)) != 0 ||
        header.bytes != file.size() || header.hash != hash_of(file))
        return {};
    return file;
}

}  // namespace

fs::path default_cache_folder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && cache[0] == '/')
        return fs::path(cache) / "himalaya";
    if (const char* home = std::getenv("HOME"); home != nullptr && home[0] == '/')
        return fs::path(home) / ".cache" / "himalaya";
    return {};
}

Result<PipelineCache> PipelineCache::open(Device& device, const fs::path& folder,
                                          Diagnostics& diagnostics) {
    PipelineCache cache;
    cache.device_ = &device;
    ByteArray file;
    std::error_code ignored;
    if (!folder.empty()) {
        const PhysicalDevice& physical = device.physical();
        cache.file_ = folder / fmt::format("pipelines-{}-{}.bin", hex(physical.device_uuid),
                                           hex(physical.cache_uuid));
        if (fs::exists(cache.file_, ignored)) {
            Result<ByteArray> read = read_file(cache.file_);
            if (read)
                file = std::move(*read);
            else
                diagnostics.warn(read.error().file, "", read.error().message);
        }
    }
    const std::span<const std::byte> initial = contents(file);
    if (!file.empty() && initial.empty())
        diagnostics.warn(cache.file_.string(), "",
                         "is damaged; pipelines are compiled anew and it is written again");
    const VkPipelineCacheCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO,
                                         .initialDataSize = initial.size(),
                                         .pInitialData = initial.data()};
    VkPipelineCache handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreatePipelineCache(device.handle(), &info, nullptr, &handle),
                        "vkCreatePipelineCache", cache.file_.string()));
    device.name(VK_OBJECT_TYPE_PIPELINE_CACHE, handle, "pipeline cache");
    cache.handle_ = {device.handle(), handle};
    cache.loaded_bytes_ = initial.size();
    cache.saved_hash_ = hash_of(initial);
    return cache;
}

Result<void> PipelineCache::save() {
    if (file_.empty()) return {};
    std::size_t size = 0;
    HM_TRY(device_->check(vkGetPipelineCacheData(device_->handle(), handle_.get(), &size, nullptr),
                          "vkGetPipelineCacheData", file_.string()));
    std::vector<std::byte> bytes(sizeof(FileHeader) + size);
    HM_TRY(device_->check(vkGetPipelineCacheData(device_->handle(), handle_.get(), &size,
                                                 bytes.data() + sizeof(FileHeader)),
                          "vkGetPipelineCacheData", file_.string()));
    bytes.resize(sizeof(FileHeader) + size);
    const std::span<const std::byte> contents = std::span(bytes).subspan(sizeof(FileHeader));
    FileHeader header;
    header.bytes = size;
    header.hash = hash_of(contents);
    if (header.hash == saved_hash_) return {};
    std::memcpy(bytes.data(), &header, sizeof(header));
    std::error_code error;
    fs::create_directories(file_.parent_path(), error);
    if (error)
        return fail(ErrorKind::unwritable, file_.parent_path().string(), "", error.message());
    HM_TRY(write_file_atomically(file_, bytes));
    saved_hash_ = header.hash;
    return {};
}

}  // namespace hm::rhi
