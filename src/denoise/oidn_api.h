// What is used of Intel Open Image Denoise 2: its C interface, declared from the library's
// documentation so that building needs nothing of it. The functions are found at run time.
#pragma once

#include <cstddef>

namespace hm::oidn {

struct DeviceHandle;
struct BufferHandle;
struct FilterHandle;
using Device = DeviceHandle*;
using Buffer = BufferHandle*;
using Filter = FilterHandle*;

// The library's numbers.
enum DeviceType : int { kDefault = 0, kCpu = 1, kSycl = 2, kCuda = 3, kHip = 4, kMetal = 5 };
enum ErrorCode : int {
    kNoError = 0,
    kUnknown = 1,
    kInvalidArgument = 2,
    kInvalidOperation = 3,
    kOutOfMemory = 4,
    kUnsupportedHardware = 5,
};
enum Format : int { kFloat = 1, kFloat3 = 3 };

// HM_OIDN(result, name, parameters), the library's name being oidn + name.
#define HM_OIDN_FUNCTIONS(HM_OIDN)                                                              \
    HM_OIDN(int, GetNumPhysicalDevices, ())                                                     \
    HM_OIDN(int, GetPhysicalDeviceInt, (int device, const char* name))                          \
    HM_OIDN(const char*, GetPhysicalDeviceString, (int device, const char* name))               \
    HM_OIDN(Device, NewDeviceByID, (int device))                                                \
    HM_OIDN(ErrorCode, GetDeviceError, (Device device, const char** message))                   \
    HM_OIDN(int, GetDeviceInt, (Device device, const char* name))                               \
    HM_OIDN(void, SetDeviceInt, (Device device, const char* name, int value))                   \
    HM_OIDN(void, SetDeviceBool, (Device device, const char* name, bool value))                 \
    HM_OIDN(void, CommitDevice, (Device device))                                                \
    HM_OIDN(void, ReleaseDevice, (Device device))                                               \
    HM_OIDN(Buffer, NewBuffer, (Device device, std::size_t bytes))                              \
    HM_OIDN(void, WriteBuffer,                                                                  \
            (Buffer buffer, std::size_t offset, std::size_t bytes, const void* from))           \
    HM_OIDN(void, ReadBuffer, (Buffer buffer, std::size_t offset, std::size_t bytes, void* to)) \
    HM_OIDN(void, ReleaseBuffer, (Buffer buffer))                                               \
    HM_OIDN(Filter, NewFilter, (Device device, const char* type))                               \
    HM_OIDN(void, SetFilterImage,                                                               \
            (Filter filter, const char* name, Buffer buffer, Format format, std::size_t width,  \
             std::size_t height, std::size_t offset, std::size_t pixel_stride,                  \
             std::size_t row_stride))                                                           \
    HM_OIDN(void, SetFilterBool, (Filter filter, const char* name, bool value))                 \
    HM_OIDN(void, CommitFilter, (Filter filter))                                                \
    HM_OIDN(void, ExecuteFilter, (Filter filter))                                               \
    HM_OIDN(void, ReleaseFilter, (Filter filter))

struct Api {
#define HM_OIDN(result, name, parameters) result(*name) parameters = nullptr;
    HM_OIDN_FUNCTIONS(HM_OIDN)
#undef HM_OIDN
};

}  // namespace hm::oidn
