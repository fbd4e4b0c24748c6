#include "rhi/acceleration_structure.h"

#include "rhi/error.h"

namespace hm::rhi {

Result<AccelerationStructure> AccelerationStructure::allocate(Device& device,
                                                              const std::string& name,
                                                              VkAccelerationStructureTypeKHR type,
                                                              std::uint64_t bytes) {
    AccelerationStructure structure;
    HM_TRY_ASSIGN(
        structure.buffer_,
        Buffer::create(device,
                       {.name = name, .size = bytes, .use = BufferUse::acceleration_structure}));
    const VkAccelerationStructureCreateInfoKHR info{
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR,
        .buffer = structure.buffer_.handle(),
        .size = bytes,
        .type = type};
    VkAccelerationStructureKHR handle = VK_NULL_HANDLE;
    HM_TRY(device.check(vkCreateAccelerationStructureKHR(device.handle(), &info, nullptr, &handle),
                        "vkCreateAccelerationStructureKHR", name));
    device.name(VK_OBJECT_TYPE_ACCELERATION_STRUCTURE_KHR, handle, name);
    structure.handle_ = {device.handle(), handle};
    const VkAccelerationStructureDeviceAddressInfoKHR address{
        .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR,
        .accelerationStructure = handle};
    structure.address_ = vkGetAccelerationStructureDeviceAddressKHR(device.handle(), &address);
    return structure;
}

}  // namespace hm::rhi
