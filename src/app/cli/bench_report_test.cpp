// The report of made-up measurements.
#include "app/cli/bench_report.h"

#include <gtest/gtest.h>

namespace hm::cli {
namespace {

SceneRates measured() {
    SceneRates rates;
    rates.samples_per_pixel = 4;
    rates.best = {400, 4000, 2.0, 0};
    return rates;
}

std::string report(const SceneRates& rates) {
    JsonWriter json;
    write_scene(json, "demo:box", rates);
    std::string text = json.text();
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    return text;
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

TEST(BenchReport, OfACpuHasNothingOfAGpu) {
    const std::string text = report(measured());
    EXPECT_TRUE(says(text, "\"samples_per_second\":200")) << text;
    EXPECT_FALSE(says(text, "one_sample")) << text;
    EXPECT_FALSE(says(text, "reordered")) << text;
}

TEST(BenchReport, PutsReorderedHitsBesideTheOthers) {
    SceneRates rates = measured();
    rates.traced = TracedRates{};
    TraceRates& plain = rates.traced->rates;
    plain.closest_rays = 600;
    plain.shadow_rays = 400;
    plain.path_ms = 4;
    EXPECT_TRUE(says(report(rates), "\"reordered\":null")) << report(rates);
    rates.traced->reordered = plain;
    rates.traced->reordered->path_ms = 2;
    rates.traced->reordered->bare_ms = 1;
    const std::string text = report(rates);
    EXPECT_TRUE(says(text,
                     "\"reordered\":{\"sorts\":false,\"gpu_milliseconds\":2,"
                     "\"rays_per_second\":500000,\"share_of_bare_rate\":0.5,\"speedup\":2}"))
        << text;
    rates.traced->sorts = true;
    EXPECT_TRUE(says(report(rates), "\"sorts\":true"));
}

}  // namespace
}  // namespace hm::cli
