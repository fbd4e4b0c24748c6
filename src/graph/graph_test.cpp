// Graphs recorded and run on a real device under synchronisation validation.
#include "graph/graph.h"

#include <gtest/gtest.h>

#include "rhi/pipeline.h"
#include "rhi/test_device.h"
#include "rhi/upload.h"
#include "shaders/add_comp.h"
#include "shaders/draw_comp.h"

namespace hm::graph {
namespace {

using rhi::test::expect_ok;
using rhi::test::value_of;

constexpr std::uint32_t kSide = 20;  // not a multiple of the workgroup size 8

// The two shaders of test_shaders/.
struct Shaders {
    rhi::SetLayout draw_set, add_set;
    rhi::PipelineLayout draw_layout, add_layout;
    rhi::ComputePipeline draw, add;
    rhi::Sampler sampler;

    explicit Shaders(rhi::Device& device) {
        const rhi::Binding target{.binding = 0, .kind = rhi::DescriptorKind::storage_image};
        const rhi::Binding source{.binding = 1, .kind = rhi::DescriptorKind::texture};
        const std::array<rhi::Binding, 2> both{target, source};
        draw_set = value_of(rhi::SetLayout::create(device, "draw", std::span(&target, 1), true));
        add_set = value_of(rhi::SetLayout::create(device, "add", both, true));
        draw_layout = value_of(make_layout(device, "draw", draw_set));
        add_layout = value_of(make_layout(device, "add", add_set));
        draw = value_of(
            rhi::ComputePipeline::create(device, "draw", draw_layout, hm::shaders::draw_comp()));
        add = value_of(
            rhi::ComputePipeline::create(device, "add", add_layout, hm::shaders::add_comp()));
        sampler = value_of(rhi::Sampler::create(device, {.name = "nearest"}));
    }

    static Result<rhi::PipelineLayout> make_layout(rhi::Device& device, const char* name,
                                                   const rhi::SetLayout& set) {
        const rhi::SetLayout* sets = &set;
        return rhi::PipelineLayout::create(device, name, std::span(&sets, 1), 4);
    }

    void run_draw(rhi::Commands& commands, const rhi::Image& target, float value) const {
        commands.bind(draw);
        commands.push_set(draw_layout, 0, rhi::DescriptorWrites(draw_set).image(0, target));
        commands.push_constants(draw_layout, value);
        commands.dispatch((kSide + 7) / 8, (kSide + 7) / 8);
    }

    void run_add(rhi::Commands& commands, const rhi::Image& sums, const rhi::Image& source,
                 float factor) const {
        commands.bind(add);
        commands.push_set(
            add_layout, 0,
            rhi::DescriptorWrites(add_set).image(0, sums).texture(1, source, sampler));
        commands.push_constants(add_layout, factor);
        commands.dispatch((kSide + 7) / 8, (kSide + 7) / 8);
    }
};

rhi::ImageInfo image_info(std::string name) {
    return {.name = std::move(name),
            .format = rhi::Format::r32f,
            .width = kSide,
            .height = kSide,
            .use = rhi::ImageUse::storage | rhi::ImageUse::sampled};
}

class RhiGraph : public rhi::test::DeviceTest {};

// sums = 10 * (10 * (10 * sums + 1) + 2) + 3 in each run, through transient images that share
// memory, and then copied out; with an unused pass.
TEST_F(RhiGraph, RunsWhatIsPlanned) {
    const Shaders shaders(device());
    const rhi::Image sums_image = value_of(rhi::Image::create(device(), image_info("sums")));
    expect_ok(rhi::run_once(device(), "zero", [&](rhi::Commands& commands) -> Result<void> {
        commands.transition(sums_image, rhi::ImageLayout::undefined, rhi::ImageLayout::general);
        commands.clear(sums_image, rhi::ImageLayout::general, 0);
        return {};
    }));
    const rhi::Buffer result = value_of(rhi::Buffer::create(
        device(),
        {.name = "result", .size = kSide * kSide * 4, .memory = rhi::MemoryKind::readback}));

    Graph graph(device(), "sums");
    Ref sums = graph.import(sums_image);
    const Ref out = graph.import(result);
    for (int i = 1; i <= 3; ++i) {
        Ref digit = graph.image(image_info("digit " + std::to_string(i)));
        Pass draw = graph.pass("draw", PassKind::compute);
        digit = draw.writes(digit);
        draw.records([&, digit, i](rhi::Commands& commands) {
            shaders.run_draw(commands, graph.image_of(digit), static_cast<float>(i));
        });
        Pass add = graph.pass("add", PassKind::compute);
        add.samples(digit);
        sums = add.updates(sums);
        add.records([&, digit](rhi::Commands& commands) {
            shaders.run_add(commands, sums_image, graph.image_of(digit), 10);
        });
    }
    const Ref nobodys = graph.image(image_info("nobody's"));
    Pass unused = graph.pass("unused", PassKind::compute);
    unused.writes(nobodys);
    unused.records([](rhi::Commands&) { FAIL() << "a culled pass is recorded"; });
    Pass copy = graph.pass("copy out", PassKind::copy);
    copy.reads(sums);
    copy.writes(out);
    copy.records([&](rhi::Commands& commands) {
        commands.copy(sums_image, rhi::ImageLayout::transfer_source, result);
    });
    expect_ok(graph.compile());
    EXPECT_EQ(graph.plan().culled.size(), 1u);
    // Three digits, one at a time.
    EXPECT_EQ(graph.plan().heap_bytes, rhi::memory_needs(device(), image_info("digit")).bytes);

    for (const float expected : {123.0f, 123123.0f}) {
        expect_ok(rhi::run_once(device(), "run", [&](rhi::Commands& commands) -> Result<void> {
            graph.record(commands);
            return {};
        }));
        const auto* texels = reinterpret_cast<const float*>(result.mapped().data());
        for (std::uint32_t i = 0; i < kSide * kSide; ++i)
            ASSERT_EQ(texels[i], expected) << i;
    }
}

// Two runs in one submission are synchronised, although the graph describes only one.
TEST_F(RhiGraph, RunsTwiceInOneSubmission) {
    const Shaders shaders(device());
    const rhi::Buffer counted =
        value_of(rhi::Buffer::create(device(), {.name = "counted", .size = kSide * kSide * 4}));
    Graph graph(device(), "twice");
    Ref image = graph.image(image_info("image"));
    Ref other = graph.image(image_info("other"));
    const Ref out = graph.import(counted);
    Pass draw = graph.pass("draw", PassKind::compute);
    image = draw.writes(image);
    draw.records(
        [&](rhi::Commands& commands) { shaders.run_draw(commands, graph.image_of(image), 5); });
    Pass start = graph.pass("start", PassKind::compute);
    other = start.writes(other);
    start.records(
        [&](rhi::Commands& commands) { shaders.run_draw(commands, graph.image_of(other), 2); });
    Pass add = graph.pass("add", PassKind::compute);
    add.samples(image);
    other = add.updates(other);
    add.records([&](rhi::Commands& commands) {
        shaders.run_add(commands, graph.image_of(other), graph.image_of(image), 3);
    });
    Pass copy = graph.pass("copy out", PassKind::copy);
    copy.reads(other);
    copy.writes(out);
    copy.records([&](rhi::Commands& commands) {
        commands.copy(graph.image_of(other), rhi::ImageLayout::transfer_source, counted);
    });
    expect_ok(graph.compile());
    expect_ok(rhi::run_once(device(), "run twice", [&](rhi::Commands& commands) -> Result<void> {
        graph.record(commands);
        graph.record(commands);
        return {};
    }));
    std::vector<float> texels(kSide * kSide);
    expect_ok(rhi::read_back(device(), counted, std::as_writable_bytes(std::span(texels))));
    EXPECT_EQ(texels, std::vector<float>(texels.size(), 11.0f));
}

}  // namespace
}  // namespace hm::graph
