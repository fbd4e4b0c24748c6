// Maps an access in a kind of pass to pipeline stages, access flags, and the required image layout.
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

// Whether the access depends on the previous contents.
inline bool reads(AccessKind kind) {
    return kind != AccessKind::write;
}

}  // namespace hm::graph
