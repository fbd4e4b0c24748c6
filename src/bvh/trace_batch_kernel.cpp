// One of the variants that trace_batch.h offers. Both namespaces are renamed per variant, so that
// the linker never uses an inline function compiled for a newer CPU in other code.
#define HM_PASTE_INNER(a, b) a##b
#define HM_PASTE(a, b) HM_PASTE_INNER(a, b)
#define hm HM_PASTE(hm_, HM_BATCH_VARIANT)
#define glm HM_PASTE(glm_, HM_BATCH_VARIANT)
#include "bvh/traverse.h"

namespace hm {

struct TraceBatch {
    const BvhView* view;
    const Ray* rays;
    Hit* hits;
    std::uint8_t* found;
    std::uint64_t count;
    std::uint32_t accept;
    std::uint64_t accept_calls;
};

}  // namespace hm

// The caller passes ::hm::TraceBatch, which has the same layout.
#define HM_BATCH_CLOSEST HM_PASTE(hm_trace_closest_, HM_BATCH_VARIANT)
#define HM_BATCH_ANY HM_PASTE(hm_trace_any_, HM_BATCH_VARIANT)

extern "C" void HM_BATCH_CLOSEST(void* argument) {
    auto& batch = *static_cast<hm::TraceBatch*>(argument);
    std::uint64_t calls = 0;
    const auto accept = [&](const hm::Hit& hit) {
        ++calls;
        return batch.accept == 0 || hit.primitive % 2 == 0;
    };
    for (std::uint64_t i = 0; i < batch.count; ++i) {
        hm::Hit hit{};
        batch.found[i] = hm::trace_closest(*batch.view, batch.rays[i], hit, accept);
        batch.hits[i] = hit;
    }
    batch.accept_calls = calls;
}

extern "C" void HM_BATCH_ANY(void* argument) {
    auto& batch = *static_cast<hm::TraceBatch*>(argument);
    std::uint64_t calls = 0;
    const auto accept = [&](const hm::Hit& hit) {
        ++calls;
        return batch.accept == 0 || hit.primitive % 2 == 0;
    };
    for (std::uint64_t i = 0; i < batch.count; ++i)
        batch.found[i] = hm::trace_any(*batch.view, batch.rays[i], accept);
    batch.accept_calls = calls;
}
