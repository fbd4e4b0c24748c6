#include "rhi/query.h"

#include "base/check.h"
#include "rhi/error.h"

namespace hm::rhi {

Result<Timestamps> Timestamps::create(Device& device, std::string_view name, std::uint32_t count) {
    Timestamps timestamps;
    timestamps.device_ = &device;
    timestamps.count_ = count;
    if (!device.physical().has(kTimestamps)) return timestamps;
    const VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO,
                                     .queryType = VK_QUERY_TYPE_TIMESTAMP,
                                     .queryCount = count};
    VkQueryPool pool = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool),
                        "vkCreateQueryPool", name));
    device.name(VK_OBJECT_TYPE_QUERY_POOL, pool, name);
    timestamps.pool_ = {device.handle(), pool};
    return timestamps;
}

void Timestamps::reset(Commands& commands) {
    if (pool_.get() != VK_NULL_HANDLE)
        vkCmdResetQueryPool(commands.handle(), pool_.get(), 0, count_);
}

void Timestamps::write(Commands& commands, std::uint32_t index) {
    HM_CHECK(index < count_, "timestamp {} of {}", index, count_);
    if (pool_.get() != VK_NULL_HANDLE)
        vkCmdWriteTimestamp2(commands.handle(), VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_.get(),
                             index);
}

Result<std::vector<double>> Timestamps::milliseconds(std::uint32_t count) const {
    HM_CHECK(count <= count_, "{} timestamps of {}", count, count_);
    std::vector<double> times(count, 0.0);
    if (pool_.get() == VK_NULL_HANDLE || count == 0) return times;
    std::vector<std::uint64_t> ticks(count);
    HM_TRY(device_->check(vkGetQueryPoolResults(device_->handle(), pool_.get(), 0, count,
                                                ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                                sizeof(std::uint64_t),
                                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
                          "vkGetQueryPoolResults", "timestamps"));
    for (std::uint32_t i = 0; i < count; ++i)
        times[i] =
            static_cast<double>(ticks[i] - ticks[0]) * device_->limits().timestamp_period_ns * 1e-6;
    return times;
}

}  // namespace hm::rhi
