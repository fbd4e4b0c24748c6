// Wuffs' code. It asks the processor what it can do thirty times for each picture, and in a virtual
// machine each question goes to the host: a quarter of a millisecond in all, as long as a small
// texture takes. So the answers are kept.
#if defined(__x86_64__)
#include <cpuid.h>

namespace {

struct Registers {
    unsigned a = 0, b = 0, c = 0, d = 0;
    int known = 0;
};

Registers ask(unsigned leaf, unsigned subleaf) {
    Registers r;
    r.known = __get_cpuid_count(leaf, subleaf, &r.a, &r.b, &r.c, &r.d);
    return r;
}

int kept_cpuid(unsigned leaf, unsigned subleaf, unsigned* a, unsigned* b, unsigned* c,
               unsigned* d) {
    static const Registers features = ask(1, 0), extended = ask(7, 0);
    const bool first = subleaf == 0;
    const Registers r = first && leaf == 1   ? features
                        : first && leaf == 7 ? extended
                                             : ask(leaf, subleaf);
    *a = r.a, *b = r.b, *c = r.c, *d = r.d;
    return r.known;
}

}  // namespace

#define __get_cpuid(leaf, a, b, c, d) kept_cpuid(leaf, 0, a, b, c, d)
#define __get_cpuid_count(leaf, subleaf, a, b, c, d) kept_cpuid(leaf, subleaf, a, b, c, d)
#endif

#define WUFFS_IMPLEMENTATION
#include "image/wuffs.h"
