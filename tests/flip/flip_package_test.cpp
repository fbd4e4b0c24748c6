// FLIP against the published package flip-evaluator 1.7: fixture.txt has its numbers for five pairs
// of pictures, make_fixture.py made it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "base/files.h"
#include "compare/flip.h"
#include "image/read.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

// Both sides compute in float. A feature's error is a square root, which turns a rounding of 1e-7
// into a few 1e-6 of FLIP where features hardly differ.
constexpr double kTolerance = 2e-5;
constexpr std::size_t kStride = 37;

fs::path tests_dir() {
    const char* dir = std::getenv("HIMALAYA_SOURCE_DIR");
    return fs::path(dir != nullptr ? dir : ".") / "tests";
}

FloatImage load(const std::string& name) {
    const fs::path path = tests_dir() / "reference/data" / (name + ".exr");
    const auto bytes = read_file(path);
    EXPECT_TRUE(bytes) << bytes.error().line();
    auto image = read_image(*bytes, name);
    EXPECT_TRUE(image) << image.error().line();
    return std::get<FloatImage>(std::move(*image));
}

void expect_equal(std::istringstream& line) {
    std::string kind, reference, test;
    double start = 0, stop = 0, count = 0, average = 0;
    line >> kind >> reference >> test >> start >> stop >> count >> average;
    SCOPED_TRACE(kind + " " + reference + " " + test);
    Plane error;
    if (kind == "HDR") {
        HdrFlip flip = hdr_flip(load(reference), load(test));
        EXPECT_NEAR(flip.start_exposure, start, 1e-5);
        EXPECT_NEAR(flip.stop_exposure, stop, 1e-5);
        EXPECT_EQ(double(flip.exposures), count);
        error = std::move(flip.error);
    } else {
        error = ldr_flip(load(reference), load(test));
    }
    EXPECT_NEAR(mean(error), average, kTolerance);
    std::size_t compared = 0;
    for (double expected = 0; line >> expected; ++compared) {
        ASSERT_LT(compared * kStride, error.values.size());
        EXPECT_NEAR(double(error.values[compared * kStride]), expected, kTolerance) << compared;
    }
    EXPECT_EQ(compared, (error.values.size() + kStride - 1) / kStride);
}

TEST(FlipPackage, FivePairsAsItHasThem) {
    std::ifstream fixture(tests_dir() / "flip/fixture.txt");
    ASSERT_TRUE(fixture);
    int lines = 0;
    for (std::string text; std::getline(fixture, text); ++lines) {
        std::istringstream line(text);
        expect_equal(line);
    }
    EXPECT_EQ(lines, 10);
}

}  // namespace
}  // namespace hm
