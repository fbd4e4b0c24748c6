// Which passes run, in which order, and what cannot be ordered.
#include <gtest/gtest.h>

#include "graph/plan.h"
#include "graph/sketch.h"

namespace hm::graph {
namespace {

using test::next;
using test::read;
using test::Sketch;
using test::update;
using test::write;

std::vector<std::uint32_t> passes_of(const Plan& plan) {
    std::vector<std::uint32_t> passes;
    for (const Step& step : plan.steps)
        passes.push_back(step.pass);
    return passes;
}

using Passes = std::vector<std::uint32_t>;

TEST(Order, FollowsVersionsNotTheList) {
    Sketch s;
    const Ref a = s.buffer("a"), out = s.imported_buffer("out");
    s.pass("last", PassKind::copy, {read(next(a)), write(out)});
    s.pass("first", PassKind::compute, {write(a)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{1, 0}));
}

TEST(Order, ReadersComeBeforeTheNextWriter) {
    Sketch s;
    const Ref a = s.buffer("a"), x = s.imported_buffer("x"), y = s.imported_buffer("y");
    s.pass("write", PassKind::compute, {write(a)});
    s.pass("write again", PassKind::compute, {write(next(a)), write(y)});
    s.pass("read the first", PassKind::compute, {read(next(a)), write(x)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{0, 2, 1}));
}

TEST(Order, WritersFollowTheirVersions) {
    Sketch s;
    const Ref a = s.imported_buffer("a");
    s.pass("second", PassKind::compute, {write(next(a))});
    s.pass("first", PassKind::compute, {write(a)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{1, 0}));
}

TEST(Order, FreePassesKeepTheirOrder) {
    Sketch s;
    for (int i = 0; i < 5; ++i)
        s.pass("p", PassKind::compute, {write(s.imported_buffer("out"))});
    EXPECT_EQ(passes_of(s.plan()), (Passes{0, 1, 2, 3, 4}));
}

TEST(Order, CirclesAreNamed) {
    Sketch s;
    const Ref a = s.imported_buffer("a"), b = s.imported_buffer("b");
    s.pass("from b to a", PassKind::compute, {read(next(b)), write(a)});
    s.pass("from a to b", PassKind::compute, {read(next(a)), write(b)});
    s.pass("apart", PassKind::compute, {write(s.imported_buffer("c"))});
    EXPECT_EQ(s.error(), "render graph: passes wait for each other: from b to a, from a to b");
}

TEST(Order, WhatNobodyWritesCannotBeRead) {
    Sketch s;
    const Ref a = s.image("a");
    s.pass("look", PassKind::compute, {read(a), write(s.imported_buffer("out"))});
    EXPECT_EQ(s.error(), "render graph: look: reads version 0 of a, which no pass writes");
}

TEST(Order, UpdatingNothingIsReadingIt) {
    Sketch s;
    s.pass("add", PassKind::compute, {update(s.image("sums")), write(s.imported_buffer("out"))});
    EXPECT_EQ(s.error(), "render graph: add: reads version 0 of sums, which no pass writes");
}

TEST(Order, TwoWritersOfOneVersionAreNamed) {
    Sketch s;
    const Ref a = s.imported_buffer("a");
    s.pass("one", PassKind::compute, {write(a)});
    s.pass("two", PassKind::compute, {write(a)});
    EXPECT_EQ(s.error(), "render graph: two: writes a over the same version as one");
}

TEST(Order, OnePassUsesAResourceOnce) {
    Sketch s;
    const Ref a = s.imported_buffer("a");
    s.pass("both", PassKind::compute, {read(a), write(a)});
    EXPECT_EQ(s.error(), "render graph: both: uses a twice");
}

TEST(Order, UnusedPassesAreCulled) {
    Sketch s;
    const Ref a = s.buffer("a"), b = s.buffer("b"), c = s.buffer("c");
    const Ref out = s.imported_buffer("out");
    s.pass("a", PassKind::compute, {write(a)});
    s.pass("b from a, unused", PassKind::compute, {read(next(a)), write(b)});
    s.pass("c from b, unused", PassKind::compute, {read(next(b)), write(c)});
    s.pass("out from a", PassKind::compute, {read(next(a)), write(out)});
    const Plan plan = s.plan();
    EXPECT_EQ(passes_of(plan), (Passes{0, 3}));
    EXPECT_EQ(plan.culled, (Passes{1, 2}));
    EXPECT_FALSE(plan.lifetimes[b.resource].has_value());

    s.declaration.passes[2].keep = true;
    EXPECT_EQ(passes_of(s.plan()), (Passes{0, 1, 2, 3}));
}

TEST(Order, OverwrittenWorkIsCulled) {
    Sketch s;
    const Ref a = s.buffer("a"), out = s.imported_buffer("out");
    s.pass("lost", PassKind::compute, {write(a)});
    s.pass("kept", PassKind::compute, {write(next(a))});
    s.pass("out", PassKind::compute, {read(next(next(a))), write(out)});
    EXPECT_EQ(passes_of(s.plan()), (Passes{1, 2}));
}

}  // namespace
}  // namespace hm::graph
