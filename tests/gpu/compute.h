// A headless Vulkan device that runs compute shaders over storage buffers: what the tests need to
// compare the shared shading files compiled as GLSL with the same files compiled as C++.
//
// A failure throws std::runtime_error with the Vulkan call and its result; GoogleTest reports it.
// Messages of the validation layer are failures too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace hm::test {

class ComputeDevice {
  public:
    // The device that all GPU tests use (rhi/test_device.h).
    ComputeDevice();
    ~ComputeDevice();
    ComputeDevice(const ComputeDevice&) = delete;
    ComputeDevice& operator=(const ComputeDevice&) = delete;

    const std::string& name() const;

  private:
    friend class ComputeShader;
    struct State;
    std::unique_ptr<State> state_;
};

// One shader's `main`, compiled for a device, which must outlive it. It sees buffer_count storage
// buffers: set 0, bindings 0 and up.
class ComputeShader {
  public:
    ComputeShader(const ComputeDevice& device, std::span<const std::uint32_t> spirv,
                  std::uint32_t buffer_count);
    ~ComputeShader();
    ComputeShader(const ComputeShader&) = delete;
    ComputeShader& operator=(const ComputeShader&) = delete;

    // Runs groups_x work groups and waits. buffers[i], which must not be empty, is copied into
    // binding i before, and back afterwards.
    void run(std::span<const std::span<std::byte>> buffers, std::uint32_t groups_x) const;

  private:
    struct Parts;
    const ComputeDevice& device_;
    std::unique_ptr<const Parts> parts_;
};

// A vector's or array's storage, for run().
template <class T>
std::span<std::byte> bytes_of(T& values) {
    return std::as_writable_bytes(std::span(values));
}

}  // namespace hm::test
