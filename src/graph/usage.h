// What an access means in a pass of some kind: at which stages, which kinds of access, and in
// which layout an image must be.
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

// Whether it needs what was there before.
inline bool reads(AccessKind kind) {
    return kind != AccessKind::write;
}

}  // namespace hm::graph
