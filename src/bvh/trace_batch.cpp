#include "bvh/trace_batch.h"

#include <vector>

#define HM_DECLARE_VARIANT(name)               \
    extern "C" {                               \
    void hm_trace_closest_##name(void* batch); \
    void hm_trace_any_##name(void* batch);     \
    }
HM_DECLARE_VARIANT(baseline)
#if defined(__x86_64__)
HM_DECLARE_VARIANT(avx2)
HM_DECLARE_VARIANT(avx512)
#endif

namespace hm {
namespace {

#define HM_VARIANT(name)                                                                            \
    TraceVariant {                                                                                  \
#name,                                                                                      \
            [](TraceBatch &                                                                         \
               batch) { hm_trace_closest_##name(&batch); },                                         \
                                                         [](TraceBatch &                            \
                                                            batch) { hm_trace_any_##name(&batch); } \
    }

std::vector<TraceVariant> make_variants() {
    std::vector<TraceVariant> variants{HM_VARIANT(baseline)};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2"))
        variants.push_back(HM_VARIANT(avx2));
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        variants.push_back(HM_VARIANT(avx512));
#endif
    return variants;
}

}  // namespace

std::span<const TraceVariant> trace_variants() {
    static const std::vector<TraceVariant> variants = make_variants();
    return variants;
}

}  // namespace hm
