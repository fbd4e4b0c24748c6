// The faster way of launching is found from simulated times, also while a clock rises.
#include "gpu/launch_choice.h"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <vector>

namespace hm {
namespace {

// Milliseconds of a submission by its number; nothing if it was too short to measure.
using Times = std::function<std::optional<double>(Launches, int)>;

// Draws with two submissions in flight, as the renderer does. Returns after how many it was
// decided.
int submissions_until_decided(LaunchChoice& choice, const Times& times) {
    std::deque<Launches> under_way;
    for (int submission = 0; submission < 200; ++submission) {
        if (under_way.size() == 2) {
            choice.learn(under_way.front(), times(under_way.front(), submission - 2));
            under_way.pop_front();
        }
        if (choice.decided()) return submission;
        under_way.push_back(choice.next());
    }
    return -1;
}

Times constant(double loop, double one_per_sample) {
    return
        [=](Launches launches, int) { return launches == Launches::loop ? loop : one_per_sample; };
}

TEST(LaunchChoice, TakesTheFasterForGood) {
    for (const Launches faster : {Launches::loop, Launches::one_per_sample}) {
        LaunchChoice choice;
        const Times times = faster == Launches::loop ? constant(5.9, 6.7) : constant(14.5, 12.4);
        const int submissions = submissions_until_decided(choice, times);
        EXPECT_GT(submissions, 0);
        EXPECT_LE(submissions, 10);
        EXPECT_EQ(choice.decided(), faster);
        for (int i = 0; i < 10; ++i) {
            EXPECT_EQ(choice.next(), faster);
            choice.learn(faster, 1e3);
        }
        EXPECT_EQ(choice.decided(), faster);
    }
}

TEST(LaunchChoice, BothComeFirstEquallyOften) {
    LaunchChoice choice;
    int looped = 0;
    std::vector<Launches> order;
    for (int i = 0; i < 8; ++i)
        order.push_back(choice.next());
    for (int pair = 0; pair < 4; ++pair) {
        EXPECT_NE(order[2 * pair], order[2 * pair + 1]) << pair;
        looped += order[2 * pair] == Launches::loop;
    }
    EXPECT_EQ(looped, 2);
}

// An idle card runs at a fourth of its rate, and its clock jumps wherever it likes.
TEST(LaunchChoice, AJumpOfTheClockDoesNotDecide) {
    for (int jump = 0; jump < 12; ++jump) {
        for (const double loop : {0.9, 1.1}) {
            LaunchChoice choice;
            submissions_until_decided(choice, [&](Launches launches, int submission) {
                const double slow = submission < jump ? 4 : 1;
                return slow * (launches == Launches::loop ? loop : 1.0);
            });
            EXPECT_EQ(choice.decided(), loop < 1 ? Launches::loop : Launches::one_per_sample)
                << jump << " " << loop;
        }
    }
}

TEST(LaunchChoice, WhatTellsNothingDecidesNothing) {
    LaunchChoice choice;
    const Times nothing = [](Launches, int) { return std::optional<double>(); };
    EXPECT_EQ(submissions_until_decided(choice, nothing), -1);
    // Neighbours only are compared: here each timing stands alone.
    LaunchChoice sparse;
    const Times alone = [](Launches launches, int submission) -> std::optional<double> {
        if (submission % 3 != 0) return std::nullopt;
        return launches == Launches::loop ? 1.0 : 2.0;
    };
    EXPECT_EQ(submissions_until_decided(sparse, alone), -1);
}

}  // namespace
}  // namespace hm
