// Wuffs' code. It asks the processor what it can do about twenty times for each picture, and in a
// virtual machine each question goes to the host: a quarter of a millisecond in all, as long as a
// small texture takes. So the answers are kept.
#if defined(__x86_64__)
#include <cpuid.h>

namespace {

struct Registers {
    unsigned a = 0, b = 0, c = 0, d = 0;
    int known = 0;
};

Registers ask(unsigned leaf) {
    Registers r;
    r.known = __get_cpuid_count(leaf, 0, &r.a, &r.b, &r.c, &r.d);
    return r;
}

int kept_cpuid(unsigned leaf, unsigned* a, unsigned* b, unsigned* c, unsigned* d) {
    static const Registers features = ask(1), extended = ask(7);
    const Registers r = leaf == 1 ? features : leaf == 7 ? extended : ask(leaf);
    *a = r.a, *b = r.b, *c = r.c, *d = r.d;
    return r.known;
}

}  // namespace

#define __get_cpuid(leaf, a, b, c, d) kept_cpuid(leaf, a, b, c, d)
#define __get_cpuid_count(leaf, subleaf, a, b, c, d) kept_cpuid(leaf, a, b, c, d)
#endif

#define WUFFS_IMPLEMENTATION
#include "image/wuffs.h"
