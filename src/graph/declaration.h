// A frame as plain data: resources, and passes with the resources that they read and write.
//
// Resources have versions. A pass reads one version; writing makes the next. So the order of the
// passes follows from what they declare, not from their position in the list.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rhi/barrier.h"

namespace hm::graph {

// What a pass runs, and so the pipeline stages at which it accesses its resources.
enum class PassKind { compute, trace, copy, build };

enum class AccessKind {
    read,        // in shaders as storage, uniform or acceleration structure; a copy's source
    sample,      // in shaders through a sampler
    write,       // all of it: what was there before is lost
    read_write,  // some of it, or reading first
};

struct Ref {
    std::uint32_t resource = 0;
    std::uint32_t version = 0;

    bool operator==(const Ref&) const = default;
};

// A read is of `ref`'s version; a write replaces it with the next.
struct Access {
    Ref ref;
    AccessKind kind = AccessKind::read;
};

struct PassDeclaration {
    std::string name;
    PassKind kind = PassKind::compute;
    std::vector<Access> accesses;
    bool keep = false;  // runs even if nobody wants what it writes
};

// The state of an imported resource before the graph, or the state that it must have after it.
struct State {
    rhi::Scope scope = rhi::kEverything;
    rhi::ImageLayout layout = rhi::ImageLayout::general;  // of images; undefined: nothing to keep
};

struct ResourceDeclaration {
    std::string name;
    bool is_image = false;
    // Imported: has contents before, and what is written to it is kept. Otherwise transient: it
    // exists from its first to its last pass.
    std::optional<State> before;
    std::optional<State> after;
    // Of a transient image's memory; 0 places it outside the heap.
    std::uint64_t bytes = 0;
    std::uint64_t alignment = 1;

    bool imported() const { return before.has_value(); }
};

struct Declaration {
    std::vector<ResourceDeclaration> resources;
    std::vector<PassDeclaration> passes;
};

}  // namespace hm::graph
