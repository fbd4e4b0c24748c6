// Denoising with the library, where scripts/fetch-oidn.sh has put it, and what is said without.
#include "denoise/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <random>

#include "compare/metrics.h"
#include "denoise/oidn_library.h"
#include "shading/lang.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSide = 96;

vec4 pixel(const FloatImage& image, std::uint32_t x, std::uint32_t y) {
    const Rgba<float>& p = image.pixels[std::size_t(y) * image.width + x];
    return vec4(p[0], p[1], p[2], p[3]);
}

void set_pixel(FloatImage& image, std::uint32_t x, std::uint32_t y, vec4 value) {
    image.pixels[std::size_t(y) * image.width + x] = {value.x, value.y, value.z, value.w};
}

FloatImage drawn(const std::function<vec4(std::uint32_t, std::uint32_t)>& draw) {
    FloatImage image(kSide, kSide);
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x)
            set_pixel(image, x, y, draw(x, y));
    return image;
}

// A bright square of texture in front of a darker gradient, far above what a display shows.
bool in_square(std::uint32_t x, std::uint32_t y) {
    return x >= 30 && x < 66 && y >= 24 && y < 72;
}
vec3 texture(std::uint32_t x, std::uint32_t y) {
    return in_square(x, y) ? ((x / 3 + y / 3) % 2 == 0 ? vec3(0.9f, 0.6f, 0.2f) : vec3(0.2f))
                           : vec3(0.5f);
}
vec4 truth(std::uint32_t x, std::uint32_t y) {
    const float light = in_square(x, y) ? 30.0f : 2.0f + 0.02f * float(y);
    return vec4(texture(x, y) * light, 1.0f);
}

struct Scene {
    FloatImage clean = drawn(truth);
    FloatImage noisy;
    FloatImage albedo = drawn([](auto x, auto y) { return vec4(texture(x, y), 1); });
    FloatImage normal =
        drawn([](auto x, auto y) { return in_square(x, y) ? vec4(0, 0, 1, 1) : vec4(0, 1, 0, 1); });

    Scene() {
        std::mt19937 random(7);
        std::gamma_distribution<float> noise(2.0f, 0.5f);  // mean 1, like light that may miss
        noisy = drawn([&](auto x, auto y) { return truth(x, y) * vec4(vec3(noise(random)), 1); });
    }
    DenoiseInput input() const {
        return {.beauty = &noisy, .albedo = &albedo, .normal = &normal, .clean_guides = true};
    }
};

// Skips where the library was never fetched; where it was, it has to work.
class Denoise : public ::testing::Test {
  protected:
    void SetUp() override {
        const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
        const bool fetched =
            source != nullptr && fs::exists(fs::path(source) / "build/oidn/version");
        auto opened = Denoiser::open(DenoiseDevice::cpu, 0);
        if (!opened && !fetched) GTEST_SKIP() << opened.error().line();
        ASSERT_TRUE(opened) << opened.error().line();
        denoiser_.emplace(std::move(*opened));
    }

    Denoised run(const DenoiseInput& input) {
        auto result = denoiser_->denoise(input);
        EXPECT_TRUE(result) << result.error().line();
        return std::move(*result);
    }

    std::optional<Denoiser> denoiser_;
    Scene scene_;
};

TEST_F(Denoise, SaysWhatItIs) {
    EXPECT_EQ(denoiser_->description().find("Open Image Denoise 2."), 0u);
    EXPECT_NE(denoiser_->description().find("on cpu"), std::string::npos);
}

TEST_F(Denoise, ComesCloserToTheTruthAndGuidesHelp) {
    const double noisy = compare_images(scene_.noisy, scene_.clean).relative_mse;
    const Denoised guided = run(scene_.input());
    const double with = compare_images(guided.picture, scene_.clean).relative_mse;
    DenoiseInput alone;
    alone.beauty = &scene_.noisy;
    const double without = compare_images(run(alone).picture, scene_.clean).relative_mse;
    EXPECT_LT(with, 0.1 * noisy);
    EXPECT_LT(without, noisy);
    EXPECT_LT(with, without);
    EXPECT_EQ(guided.replaced_pixels, 0u);
    // Radiance is not clamped: the square's light texels are at 27.
    EXPECT_GT(pixel(guided.picture, 49, 49).x, 5.0f);
}

TEST_F(Denoise, NoisyGuidesAreDenoisedFirst) {
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0.0f, 0.1f);
    FloatImage noisy_albedo =
        drawn([&](auto x, auto y) { return vec4(texture(x, y) + vec3(noise(random)), 1); });
    DenoiseInput input = scene_.input();
    input.albedo = &noisy_albedo;
    input.clean_guides = false;
    const double prefiltered = compare_images(run(input).picture, scene_.clean).relative_mse;
    input.clean_guides = true;  // a lie
    const double taken_as_clean = compare_images(run(input).picture, scene_.clean).relative_mse;
    EXPECT_LT(prefiltered, taken_as_clean);
}

TEST_F(Denoise, BrokenPixelsAreReplacedAndCounted) {
    FloatImage broken = scene_.noisy;
    set_pixel(broken, 10, 10, vec4(std::nanf(""), 1, 1, 1));
    set_pixel(broken, 50, 40, vec4(std::numeric_limits<float>::infinity()));
    FloatImage broken_normal = scene_.normal;
    set_pixel(broken_normal, 1, 1, vec4(std::nanf("")));
    DenoiseInput input = scene_.input();
    input.beauty = &broken;
    input.normal = &broken_normal;
    const Denoised result = run(input);
    EXPECT_EQ(result.replaced_pixels, 3u);
    for (std::uint32_t y = 0; y < kSide; ++y)
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const vec4 p = pixel(result.picture, x, y);
            ASSERT_TRUE(std::isfinite(p.x + p.y + p.z + p.w)) << x << ", " << y;
        }
    EXPECT_LT(compare_images(result.picture, scene_.clean).relative_mse,
              0.1 * compare_images(scene_.noisy, scene_.clean).relative_mse);
    EXPECT_TRUE(std::isnan(pixel(broken, 10, 10).x));  // the raw picture stays
}

TEST_F(Denoise, AlphaIsDenoisedWhereAskedFor) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> coin(0, 1);
    const auto coverage = [](auto x, auto y) { return in_square(x, y) ? 0.5f : 0.0f; };
    // Four samples that each hit a half-transparent square or not.
    FloatImage noisy = drawn([&](auto x, auto y) {
        float hits = 0;
        for (int i = 0; i < 4; ++i)
            hits += coin(random) < coverage(x, y) ? 0.25f : 0.0f;
        return vec4(vec3(hits), hits);
    });
    const auto alpha_error = [&](const FloatImage& image) {
        double sum = 0;
        for (std::uint32_t y = 0; y < kSide; ++y)
            for (std::uint32_t x = 0; x < kSide; ++x)
                sum += std::pow(double(pixel(image, x, y).w - coverage(x, y)), 2);
        return sum / (kSide * kSide);
    };
    DenoiseInput input = scene_.input();
    input.beauty = &noisy;
    EXPECT_EQ(alpha_error(run(input).picture), alpha_error(noisy));
    input.alpha = true;
    const Denoised result = run(input);
    EXPECT_LT(alpha_error(result.picture), 0.2 * alpha_error(noisy));
    for (std::uint32_t i = 0; i < kSide; ++i)
        EXPECT_TRUE(pixel(result.picture, i, i).w >= 0 && pixel(result.picture, i, i).w <= 1);
    // The same everywhere: there is no noise, and nothing may change.
    DenoiseInput opaque = scene_.input();
    opaque.alpha = true;
    EXPECT_EQ(pixel(run(opaque).picture, 3, 3).w, 1.0f);
}

// Constant grey has nothing to take out, whatever the size: a picture's edges are not black.
TEST_F(Denoise, SmallAndThinPicturesKeepTheirMean) {
    for (const auto& [width, height] :
         {std::pair(1u, 1u), {64u, 1u}, {1u, 64u}, {128u, 2u}, {30u, 30u}, {63u, 200u}}) {
        FloatImage grey(width, height);
        for (Rgba<float>& p : grey.pixels)
            p = {0.5f, 0.5f, 0.5f, 1.0f};
        DenoiseInput input;
        input.beauty = &grey;
        const Denoised result = run(input);
        ASSERT_EQ(result.picture.pixels.size(), grey.pixels.size());
        for (const Rgba<float>& p : result.picture.pixels)
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(p[c], 0.5f, 0.01f) << width << " x " << height;
    }
}

// The library takes luminance under 1e-8 for black. The scale is a power of two, so the bits of
// what is filtered differ by the choice of the scale alone.
TEST_F(Denoise, AnyUnitOfRadiance) {
    const FloatImage reference = run(scene_.input()).picture;
    for (const float unit : {1e-30f, 1e-12f, 1e12f, 1e30f}) {
        FloatImage scaled = scene_.noisy;
        for (Rgba<float>& p : scaled.pixels)
            for (std::size_t c = 0; c < 3; ++c)
                p[c] *= unit;
        DenoiseInput input = scene_.input();
        input.beauty = &scaled;
        FloatImage back = run(input).picture;
        for (Rgba<float>& p : back.pixels)
            for (std::size_t c = 0; c < 3; ++c)
                p[c] /= unit;
        EXPECT_LT(compare_images(back, reference).relative_mse, 1e-4) << unit;
    }
}

TEST_F(Denoise, NegativeValuesAreCounted) {
    FloatImage negative = scene_.noisy;
    set_pixel(negative, 5, 5, vec4(-1, 1, 1, 1));
    set_pixel(negative, 7, 5, vec4(-1, -2, -3, 1));
    DenoiseInput input = scene_.input();
    input.beauty = &negative;
    EXPECT_EQ(run(input).negative_pixels, 2u);
    EXPECT_EQ(run(scene_.input()).negative_pixels, 0u);
}

// An opaque thing in front of nothing: only at its edge may alpha be anything but 0 and 1.
TEST_F(Denoise, CertainAlphaStays) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> noise(0, 1);
    const auto edge = [](auto x, auto y) {
        return in_square(x, y) && (x == 30 || x == 65 || y == 24 || y == 71);
    };
    FloatImage noisy = drawn([&](auto x, auto y) {
        const float alpha = edge(x, y) ? noise(random) : in_square(x, y) ? 1.0f : 0.0f;
        return vec4(vec3(alpha * (0.5f + noise(random))), alpha);
    });
    DenoiseInput input;
    input.beauty = &noisy;
    input.alpha = true;
    const FloatImage result = run(input).picture;
    for (std::uint32_t y = 1; y + 1 < kSide; ++y)
        for (std::uint32_t x = 1; x + 1 < kSide; ++x) {
            bool near_edge = false;
            for (std::uint32_t v = y - 1; v <= y + 1; ++v)
                for (std::uint32_t u = x - 1; u <= x + 1; ++u)
                    near_edge |= edge(u, v);
            if (near_edge) continue;
            ASSERT_EQ(pixel(result, x, y).w, in_square(x, y) ? 1.0f : 0.0f) << x << ", " << y;
        }
}

TEST_F(Denoise, TheSameInputGivesTheSameBits) {
    EXPECT_EQ(run(scene_.input()).picture.pixels, run(scene_.input()).picture.pixels);
}

TEST_F(Denoise, ADeviceThatIsNotThereIsNamed) {
    const auto opened = Denoiser::open(DenoiseDevice::hip, 0);
    if (opened) GTEST_SKIP() << "this machine has an AMD GPU";
    EXPECT_EQ(opened.error().kind, ErrorKind::no_device);
    EXPECT_NE(opened.error().message.find("has no hip device; it finds"), std::string::npos)
        << opened.error().message;
}

// HIMALAYA_OIDN for the length of a test.
class Chosen {
  public:
    explicit Chosen(const fs::path& value) {
        if (const char* before = std::getenv("HIMALAYA_OIDN")) before_ = before;
        ::setenv("HIMALAYA_OIDN", value.c_str(), 1);
    }
    ~Chosen() {
        if (before_)
            ::setenv("HIMALAYA_OIDN", before_->c_str(), 1);
        else
            ::unsetenv("HIMALAYA_OIDN");
    }

  private:
    std::optional<std::string> before_;
};

TEST(OidnLibrary, WithoutItTheErrorSaysHowToGetIt) {
    const Chosen chosen("/nowhere/at/all");
    const auto opened = Denoiser::open(DenoiseDevice::fastest, 0);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, ErrorKind::no_device);
    for (const char* part : {"HIMALAYA_OIDN is \"/nowhere/at/all\"", "libOpenImageDenoise.so.2",
                             "scripts/fetch-oidn.sh"})
        EXPECT_NE(opened.error().message.find(part), std::string::npos) << opened.error().message;
}

TEST(OidnLibrary, WhatIsNoneIsRefused) {
    const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
    ASSERT_NE(source, nullptr);
    const Chosen chosen(fs::path(source) / "README.md");
    const auto library = oidn::load_library();
    ASSERT_FALSE(library);
    EXPECT_EQ(library.error().kind, ErrorKind::no_device);
    EXPECT_NE(library.error().message.find("README.md"), std::string::npos)
        << library.error().message;
}

}  // namespace
}  // namespace hm
