// A headless Vulkan device that runs compute shaders over storage buffers: what the tests need to
// compare the shared shading files compiled as GLSL with the same files compiled as C++.
//
// A failure throws std::runtime_error with the Vulkan call and its result; GoogleTest reports it.
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
    // The fastest kind of device that the loader offers and that has scalar block layout.
    ComputeDevice();
    ~ComputeDevice();
    ComputeDevice(const ComputeDevice&) = delete;
    ComputeDevice& operator=(const ComputeDevice&) = delete;

    const std::string& name() const;

    // Runs `main` of the shader over groups_x work groups and waits. buffers[i] is copied into
    // storage buffer (set 0, binding i) before, and back from it afterwards; none is empty.
    void run(std::span<const std::uint32_t> spirv, std::span<const std::span<std::byte>> buffers,
             std::uint32_t groups_x);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// The words of a SPIR-V file.
std::vector<std::uint32_t> read_spirv(const std::string& path);

// A vector's or array's storage, for run().
template <class T>
std::span<std::byte> bytes_of(T& values) {
    return std::as_writable_bytes(std::span(values));
}

}  // namespace hm::test
