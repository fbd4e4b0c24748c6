// Lifetimes of transient images and their placement in memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "graph/plan.h"
#include "graph/sketch.h"

namespace hm::graph {
namespace {

using test::next;
using test::sample;
using test::Sketch;
using test::write;

TEST(Placement, LivesFromFirstToLastUse) {
    Sketch s;
    const Ref a = s.image("a", 64), b = s.image("b", 64), out = s.imported_buffer("out");
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b", PassKind::compute, {write(b)});
    s.pass("out", PassKind::compute, {sample(next(b)), sample(next(a)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.lifetimes[a.resource], (Lifetime{0, 2}));
    EXPECT_EQ(plan.lifetimes[b.resource], (Lifetime{1, 2}));
    EXPECT_EQ(plan.lifetimes[out.resource], (Lifetime{2, 2}));
    EXPECT_EQ(plan.heap_bytes, 128u);
    EXPECT_FALSE(plan.offsets[out.resource].has_value());
}

// A chain of eight images, each computed from the previous one: two offsets alternate.
TEST(Placement, AChainNeedsTwoPlaces) {
    Sketch s;
    Ref last = s.image("first", 1000);
    s.pass("first", PassKind::compute, {write(last)});
    for (int i = 0; i < 7; ++i) {
        const Ref image = s.image("next", 1000);
        s.pass("next", PassKind::compute, {sample(next(last)), write(image)});
        last = image;
    }
    s.pass("out", PassKind::compute, {sample(next(last)), write(s.imported_buffer("out"))});
    EXPECT_EQ(s.plan().heap_bytes, 2000u);
}

TEST(Placement, RespectsAlignment) {
    Sketch s;
    const Ref a = s.image("a", 1000), b = s.image("b", 10), out = s.imported_buffer("out");
    s.declaration.resources[b.resource].alignment = 256;
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b", PassKind::compute, {write(b)});
    s.pass("out", PassKind::compute, {sample(next(a)), sample(next(b)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(plan.offsets[b.resource], 1024u);
    EXPECT_EQ(plan.heap_bytes, 1034u);
}

// 300 random graphs: images with overlapping lifetimes never share a byte, offsets are aligned, and
// aliasing saves memory overall.
TEST(Placement, OverlappingLivesNeverShareMemory) {
    std::mt19937 random(7);
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    std::uint64_t heap = 0, apart = 0;
    for (int round = 0; round < 300; ++round) {
        Sketch s;
        std::vector<Ref> made;
        const std::uint32_t passes = 3 + below(15);
        for (std::uint32_t p = 0; p < passes; ++p) {
            std::vector<Access> accesses;
            const Ref image = s.image("image", 1 + below(5000));
            s.declaration.resources[image.resource].alignment = 1u << below(9);
            // Up to three existing images, each at most once.
            for (std::uint32_t r = made.empty() ? 0 : 1 + below(3); r > 0; --r) {
                const Ref source =
                    made[made.size() - 1 -
                         below(static_cast<std::uint32_t>(std::min<std::size_t>(made.size(), 5)))];
                const bool used =
                    std::ranges::any_of(accesses, [&](const Access& a) { return a.ref == source; });
                if (!used) accesses.push_back(sample(source));
            }
            accesses.push_back(write(image));
            s.pass("pass", PassKind::compute, std::move(accesses));
            made.push_back(next(image));
        }
        s.pass("out", PassKind::compute, {sample(made.back()), write(s.imported_buffer("out"))});
        const Plan plan = s.plan();
        heap += plan.heap_bytes;
        const std::vector<ResourceDeclaration>& r = s.declaration.resources;
        for (std::size_t i = 0; i < r.size(); ++i) {
            if (!plan.offsets[i]) continue;
            apart += r[i].bytes;
            EXPECT_EQ(*plan.offsets[i] % r[i].alignment, 0u);
            EXPECT_LE(*plan.offsets[i] + r[i].bytes, plan.heap_bytes);
            for (std::size_t j = 0; j < i; ++j) {
                if (!plan.offsets[j] || !plan.lifetimes[i]->overlaps(*plan.lifetimes[j])) continue;
                EXPECT_TRUE(*plan.offsets[i] + r[i].bytes <= *plan.offsets[j] ||
                            *plan.offsets[j] + r[j].bytes <= *plan.offsets[i])
                    << "round " << round << ": " << i << " and " << j;
            }
        }
    }
    EXPECT_LT(heap, apart);
}

}  // namespace
}  // namespace hm::graph
