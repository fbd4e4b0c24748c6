// A frame as plain data: resources, and passes with the resources that they read and write.
//
// Resources have versions. A pass reads one version; writing creates the next. So the order of the
// passes follows from the accesses they declare, not from their position in the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rhi/barrier.h"

namespace hm::graph {

// The kind of commands in a pass, which determines the pipeline stages of its accesses.
enum class PassKind { compute, trace, copy, build };

enum class AccessKind {
    read,        // in shaders as storage, uniform or acceleration structure; a copy's source
    sample,      // in shaders through a sampler
    write,       // overwrites all of it: the previous contents are discarded
    read_write,  // reads and writes, or overwrites only a part
};

struct Ref {
    std::uint32_t resource = 0;
    std::uint32_t version = 0;

    bool operator==(const Ref&) const = default;
};

// A read accesses `ref`'s version; a write replaces that version with the next.
struct Access {
    Ref ref;
    AccessKind kind = AccessKind::read;
};

struct PassDeclaration {
    std::string name;
    PassKind kind = PassKind::compute;
    std::vector<Access> accesses;
    bool keep = false;  // never culled, even if its outputs are unused
};

// The state of an imported resource before the graph, or the state that it must have after it.
struct State {
    rhi::Scope scope = rhi::kEverything;
    rhi::ImageLayout layout = rhi::ImageLayout::general;  // images; undefined: contents not kept
};

struct ResourceDeclaration {
    std::string name;
    bool is_image = false;
    // Set for imported resources, which have contents before the graph and keep what is written.
    // Otherwise the resource is transient: it exists from its first to its last pass.
    std::optional<State> before;
    std::optional<State> after;
    // Memory requirements of a transient image; 0 bytes places it outside the heap.
    std::uint64_t bytes = 0;
    std::uint64_t alignment = 1;

    bool imported() const { return before.has_value(); }
};

struct Declaration {
    std::vector<ResourceDeclaration> resources;
    std::vector<PassDeclaration> passes;
};

}  // namespace hm::graph
