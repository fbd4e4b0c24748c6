#include "gpu/compute.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "rhi/commands.h"
#include "rhi/pipeline.h"
#include "rhi/test_device.h"
#include "rhi/upload.h"

namespace hm::test {

using rhi::test::value_of;

namespace {

void expect_ok(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().line());
}

}  // namespace

struct ComputeDevice::State {
    std::shared_ptr<rhi::Instance> instance = rhi::test::make_instance();
    std::unique_ptr<rhi::Device> device =
        value_of(rhi::Device::create(instance, rhi::test::any_device(*instance)));
};

ComputeDevice::ComputeDevice() : state_(std::make_unique<State>()) {}

ComputeDevice::~ComputeDevice() {
    state_->device.reset();
    for (const rhi::Message& message : state_->instance->messages().take())
        ADD_FAILURE() << message.line();
}

const std::string& ComputeDevice::name() const {
    return state_->device->physical().name;
}

struct ComputeShader::Parts {
    rhi::SetLayout set_layout;
    rhi::PipelineLayout layout;
    rhi::ComputePipeline pipeline;

    Parts(rhi::Device& device, std::span<const std::uint32_t> spirv, std::uint32_t buffer_count) {
        std::vector<rhi::Binding> bindings;
        for (std::uint32_t i = 0; i < buffer_count; ++i)
            bindings.push_back({.binding = i});
        set_layout = value_of(rhi::SetLayout::create(device, "buffers", bindings));
        const rhi::SetLayout* sets = &set_layout;
        layout = value_of(rhi::PipelineLayout::create(device, "buffers", std::span(&sets, 1)));
        pipeline = value_of(rhi::ComputePipeline::create(device, "test shader", layout, spirv));
    }
};

ComputeShader::ComputeShader(const ComputeDevice& device, std::span<const std::uint32_t> spirv,
                             std::uint32_t buffer_count)
    : device_(device),
      parts_(std::make_unique<Parts>(*device.state_->device, spirv, buffer_count)) {}
ComputeShader::~ComputeShader() = default;

void ComputeShader::run(std::span<const std::span<std::byte>> buffers,
                        std::uint32_t groups_x) const {
    if (buffers.size() != parts_->set_layout.bindings().size())
        throw std::runtime_error("the shader was made for another number of buffers");
    rhi::Device& device = *device_.state_->device;
    rhi::DescriptorSet set =
        value_of(rhi::DescriptorSet::create(device, "buffers", parts_->set_layout));
    rhi::DescriptorWrites writes(parts_->set_layout);
    std::vector<rhi::Buffer> on_device;
    for (const std::span<std::byte> host : buffers) {
        // Host-visible: fast enough at the tests' sizes.
        on_device.push_back(value_of(rhi::Buffer::create(
            device, {.name = "buffer", .size = host.size(), .memory = rhi::MemoryKind::readback})));
        std::ranges::copy(host, on_device.back().mapped().begin());
        writes.buffer(static_cast<std::uint32_t>(on_device.size() - 1), on_device.back());
    }
    set.update(writes);
    expect_ok(rhi::run_once(device, "test", [&](rhi::Commands& commands) -> Result<void> {
        commands.bind(parts_->pipeline);
        commands.bind_set(parts_->layout, 0, set);
        commands.dispatch(groups_x);
        return {};
    }));
    for (std::size_t i = 0; i < buffers.size(); ++i)
        std::ranges::copy(on_device[i].mapped(), buffers[i].begin());
}

}  // namespace hm::test
