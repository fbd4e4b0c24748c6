// The render graph: passes declare what they read and write; the graph orders them, inserts
// barriers between them and aliases the memory of transient images whose lifetimes do not overlap.
//
//   Graph graph(device, "frame");
//   Ref sums = graph.import(accumulation);
//   Ref noise = graph.image({.name = "noise", ...});
//   Pass draw = graph.pass("draw noise", PassKind::compute);
//   noise = draw.writes(noise);
//   draw.records([&](rhi::Commands& commands) { ... graph.image_of(noise) ... });
//   Pass add = graph.pass("add", PassKind::compute);
//   add.reads(noise);
//   sums = add.updates(sums);
//   add.records(...);
//   HM_TRY(graph.compile());
//   graph.record(commands);   // any number of times, into commands that run in sequence
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "graph/declaration.h"
#include "graph/plan.h"
#include "rhi/buffer.h"
#include "rhi/commands.h"
#include "rhi/image.h"
#include "rhi/memory_block.h"

namespace hm::graph {

class Graph;

// Declares one pass. writes() and updates() return the version that the pass produces.
class Pass {
  public:
    Pass& reads(Ref ref);
    Pass& samples(Ref ref);
    Ref writes(Ref ref);   // overwrites all of it; the previous contents are discarded
    Ref updates(Ref ref);  // reads and writes, or writes a part
    Pass& keeps();         // never culled, even if its results are unused
    void records(std::function<void(rhi::Commands&)> record);

  private:
    friend class Graph;
    Pass(Graph& graph, std::uint32_t index) : graph_(&graph), index_(index) {}
    PassDeclaration& declaration();

    Graph* graph_;
    std::uint32_t index_;
};

class Graph {
  public:
    Graph(rhi::Device& device, std::string name) : device_(&device), name_(std::move(name)) {}
    Graph(const Graph&) = delete;
    Graph& operator=(const Graph&) = delete;

    // Imported resources, which must outlive the graph. The image is in `layout` whenever the graph
    // begins and ends; barriers order the graph after earlier and before later work.
    Ref import(const rhi::Image& image, rhi::ImageLayout layout = rhi::ImageLayout::general);
    Ref import(const rhi::Buffer& buffer);
    // Transient resources: created by compile(), with undefined contents until a pass writes them.
    Ref image(const rhi::ImageInfo& info);
    Ref buffer(const rhi::BufferInfo& info);

    Pass pass(std::string name, PassKind kind);

    // Computes the plan and creates the transient resources. Does nothing if nothing was declared
    // since the last call.
    Result<void> compile();
    void record(rhi::Commands& commands) const;

    const Plan& plan() const { return plan_; }
    const rhi::Image& image_of(Ref ref) const;
    const rhi::Buffer& buffer_of(Ref ref) const;

  private:
    friend class Pass;
    // The buffer or image of a resource, indexed like the declaration. Owns transient ones.
    struct Resource {
        const rhi::Image* image = nullptr;
        const rhi::Buffer* buffer = nullptr;
        rhi::ImageInfo image_info;
        rhi::BufferInfo buffer_info;
        rhi::Image own_image;
        rhi::Buffer own_buffer;
    };
    Ref add(ResourceDeclaration declared, Resource resource);
    Result<void> make_transients();
    void barriers(rhi::Commands& commands, const std::vector<PlannedBarrier>& planned) const;

    rhi::Device* device_;
    std::string name_;
    Declaration declaration_;
    std::vector<std::function<void(rhi::Commands&)>> records_;  // by pass
    rhi::MemoryBlock heap_;
    std::vector<Resource> resources_;
    Plan plan_;
};

}  // namespace hm::graph
