// Runs one topic's cases as GLSL on a Vulkan device and as C++, and compares. Built once per topic:
// HM_CASES_TOPIC is its name, HM_CASES_FILE its header, shaders/cases.h the compiled parity.comp;
// HM_CASES_OF_STAGES is defined if the topic needs the stages' tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "gpu/compute.h"
#include "shaders/cases.h"
#include HM_CASES_FILE

namespace hm {

namespace {

std::vector<vec3> make_directions() {
    std::mt19937 random(20);
    std::normal_distribution<double> normal;
    std::vector<vec3> directions(kDirections);
    for (vec3& direction : directions) {
        const glm::dvec3 v(normal(random), normal(random), normal(random));
        direction = vec3(v / glm::length(v));
    }
    return directions;
}

}  // namespace

const std::vector<vec3> case_directions = make_directions();

namespace {

constexpr std::uint32_t kCases = 1u << 20;
constexpr std::uint32_t kGroupSize = 64;

// Below this magnitude differences are absolute: results that cancel to zero, such as a component
// of a unit vector.
constexpr float kFloor = 1e-2f;

float relative_difference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    if (!std::isfinite(a) || !std::isfinite(b)) return HUGE_VALF;
    return std::abs(a - b) / std::max({std::abs(a), std::abs(b), kFloor});
}

struct Results {
    std::vector<CaseResult> gpu{kCases};
    std::vector<CaseResult> cpu{kCases};
};

// Fills results.gpu; `tables` follow the two buffers that every topic has.
void run_shader(const test::ComputeDevice& device, std::span<const std::span<std::byte>> tables,
                Results& results) {
    std::vector<vec3> directions = case_directions;
    std::vector<std::span<std::byte>> buffers = {test::bytes_of(results.gpu),
                                                 test::bytes_of(directions)};
    buffers.insert(buffers.end(), tables.begin(), tables.end());
    const test::ComputeShader shader(device, shaders::cases(),
                                     static_cast<std::uint32_t>(buffers.size()));
    shader.run(buffers, kCases / kGroupSize);
}

#ifdef HM_CASES_OF_STAGES
void run_cases(const test::ComputeDevice& device, Results& results) {
    const test::TestScene scene;
    StageCases cases(scene.flat);
    cases.params = scene.params();
    test::PathTracer::Settings settings;
    run_shader(device, cases.buffers(settings), results);
    for (std::uint32_t i = 0; i < kCases; ++i)
        cases.run_case(i, results.cpu[i]);
}
#else
void run_cases(const test::ComputeDevice& device, Results& results) {
    run_shader(device, {}, results);
    for (std::uint32_t i = 0; i < kCases; ++i)
        run_case(i, results.cpu[i]);
}
#endif

void compare_value(const Results& results, std::size_t k) {
    std::vector<float> differences(kCases);
    float low = HUGE_VALF;
    float high = -HUGE_VALF;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < kCases; ++i) {
        const float gpu = results.gpu[i].values[k];
        differences[i] = relative_difference(gpu, results.cpu[i].values[k]);
        if (differences[i] > differences[worst]) worst = i;
        low = std::min(low, gpu);
        high = std::max(high, gpu);
    }
    const float largest = differences[worst];
    const auto p99 = differences.begin() + kCases / 100 * 99;
    std::ranges::nth_element(differences, p99);
    // Beyond the percentile nothing may differ much, except where a different branch was taken.
    const auto far = std::ranges::count_if(differences, [](float d) { return d > 1e-2f; });
    std::printf("value %zu: p99 %.1e, largest %.1e, %ld above 1e-2\n", k, double(*p99),
                double(largest), long(far));
    EXPECT_LT(*p99, 1e-4f) << "value " << k;
    EXPECT_LE(far, kCases / 100000)
        << "value " << k << ", worst in case " << worst << ": " << results.gpu[worst].values[k]
        << " in GLSL, " << results.cpu[worst].values[k] << " in C++";
    EXPECT_LT(low, high) << "value " << k << " is the same in every case";
}

void compare_choice(const Results& results, std::size_t k) {
    std::uint32_t flips = 0;
    bool varies = false;
    for (std::size_t i = 0; i < kCases; ++i) {
        flips += results.gpu[i].choices[k] != results.cpu[i].choices[k] ? 1u : 0u;
        varies |= results.gpu[i].choices[k] != results.gpu[0].choices[k];
    }
    std::printf("choice %zu: %u flips of %u\n", k, flips, kCases);
    EXPECT_LE(flips, kCases / 100000) << "choice " << k;
    EXPECT_TRUE(varies) << "choice " << k << " is the same in every case";
}

// The topic is a macro, which TEST would not expand.
#define HM_PARITY_TEST(topic) TEST(Parity, topic)

HM_PARITY_TEST(HM_CASES_TOPIC) {
    const test::ComputeDevice device;
    std::printf("on %s\n", device.name().c_str());
    Results results;
    run_cases(device, results);
    for (std::size_t k = 0; k < kValues; ++k)
        compare_value(results, k);
    for (std::size_t k = 0; k < kChoices; ++k)
        compare_choice(results, k);
}

}  // namespace
}  // namespace hm
