// When two pictures count as the same, and what the doctor makes of it.
#include "app/cli/doctor/trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/cli/doctor/report.h"
#include "app/cli/info.h"

namespace hm::cli {
namespace {

// 100 pixels of one sample each, all of radiance 1.
Film even_film() {
    Film film({0, 0, 10, 10});
    for (PixelSum& sum : film.sums)
        sum = {vec3(1), 1, 1, 0};
    return film;
}

TEST(Parity, OfAPictureWithItselfIsPerfect) {
    const Parity p = compare_films(even_film(), even_film());
    EXPECT_EQ(p.mean_difference, 0);
    EXPECT_EQ(p.share_close, 1);
    EXPECT_TRUE(p.holds());
}

TEST(Parity, SeesAPictureThatIsBrighterAllOver) {
    Film film = even_film();
    for (PixelSum& sum : film.sums)
        sum.radiance *= 1.005f;
    const Parity p = compare_films(film, even_film());
    EXPECT_NEAR(p.mean_difference, 0.005, 1e-6);
    EXPECT_LT(p.standard_error, 1e-6);
    EXPECT_EQ(p.share_close, 1);
    EXPECT_FALSE(p.holds());
}

// One pixel of 100 may be far off: its standard error covers the mean. Two are too many.
TEST(Parity, AllowsOnePixelInAHundred) {
    Film film = even_film();
    film.sums[17].radiance = vec3(1.5f);
    EXPECT_TRUE(compare_films(film, even_film()).holds());
    film.sums[18].radiance = vec3(0.5f);
    const Parity p = compare_films(film, even_film());
    EXPECT_NEAR(p.share_close, 0.98, 1e-9);
    EXPECT_FALSE(p.holds());
}

TEST(Parity, NeverHoldsForNothingOrNaN) {
    EXPECT_FALSE(compare_films(Film({0, 0, 10, 10}), even_film()).holds());
    Film film = even_film();
    for (PixelSum& sum : film.sums)
        sum.radiance.y = NAN;
    EXPECT_FALSE(compare_films(film, even_film()).holds());
}

TEST(Verdict, IsTheWorstOfWhatWasFound) {
    Diagnosis d;
    d.findings = {{Level::good, "CPU", "good"}, {Level::note, "device", "software"}};
    d.trials.resize(2);
    d.trials[1].parity = Parity{0, 0, 1};
    EXPECT_EQ(verdict(d), ExitCode::ok);
    d.findings.push_back({Level::warning, "devices", "no GPU"});
    EXPECT_EQ(verdict(d), ExitCode::warned);
    d.trials[1].parity->share_close = 0.5;
    EXPECT_EQ(verdict(d), ExitCode::device_failed);
    d.trials[1] = {};
    d.trials[1].trouble = "vkQueueSubmit2 returned VK_ERROR_DEVICE_LOST";
    EXPECT_EQ(verdict(d), ExitCode::device_failed);
    EXPECT_NE(doctor_text(d).find("VK_ERROR_DEVICE_LOST"), std::string::npos);
    EXPECT_NE(doctor_json(d).find("\"passed\": false"), std::string::npos);
}

}  // namespace
}  // namespace hm::cli
