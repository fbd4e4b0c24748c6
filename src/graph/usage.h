// What an access means in a kind of pass: pipeline stages, access flags, and the layout that an
// image must have.
#pragma once

#include "graph/declaration.h"
#include "rhi/barrier.h"

namespace hm::graph {

struct Usage {
    rhi::Scope scope;
    rhi::ImageLayout layout = rhi::ImageLayout::general;
};

Usage usage_of(PassKind pass, AccessKind access);

inline bool writes(AccessKind kind) {
    return kind == AccessKind::write || kind == AccessKind::read_write;
}

// Whether it needs the earlier contents.
inline bool reads(AccessKind kind) {
    return kind != AccessKind::write;
}

}  // namespace hm::graph
