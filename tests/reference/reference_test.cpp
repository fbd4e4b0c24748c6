// Our pictures against Mitsuba 3's: another renderer, by other people, on scenes described twice.
// The stored means and variances come from make_references.py.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "base/json_document.h"
#include "cpu/render.h"
#include "image/read.h"
#include "image/write.h"
#include "reference/compare.h"
#include "reference/scenes.h"
#include "scene/render_params.h"
#include "shading/tables/tables.h"
#include "support/scenes.h"

namespace hm::test {
namespace {

constexpr int kReplicates = 32;
// A picture whose expectation is right fails by chance less often than this on each scale.
constexpr double kLevel = 1e-4;

std::filesystem::path data_folder() {
    const char* source = std::getenv("HIMALAYA_SOURCE_DIR");
    return std::filesystem::path(source == nullptr ? "." : source) / "tests/reference/data";
}

std::vector<double> read_values(const std::string& name) {
    const std::filesystem::path path = data_folder() / (name + ".exr");
    const Result<ByteArray> bytes = read_file(path);
    if (!bytes) throw std::runtime_error(path.string() + " can't be read");
    const Result<AnyImage> read = read_image(*bytes, path.string());
    const FloatImage* image = read ? std::get_if<FloatImage>(&*read) : nullptr;
    if (!image || image->width != kReferenceWidth || image->height != kReferenceHeight)
        throw std::runtime_error(path.string() + " is not a stored reference");
    std::vector<double> values;
    for (const Rgba<float>& pixel : image->pixels)
        values.insert(values.end(), pixel.begin(), pixel.begin() + 3);
    return values;
}

Estimate read_reference(const std::string& name) {
    const std::string file = (data_folder() / "references.json").string();
    const ByteArray bytes = read_file(file).value();
    const JsonDocument document = JsonDocument::parse(bytes, file).value();
    const auto replicates =
        document.root().at("/scenes/" + pointer_token(name)).value().integer("replicates").value();
    return {kReferenceWidth, kReferenceHeight, int(replicates.value()), read_values(name),
            read_values(name + "_variance")};
}

Estimate render(const ReferenceCase& c, std::uint32_t samples) {
    const FlatScene flat = flatten_quietly(c.scene, c.environment);
    CpuRenderer renderer(flat, 1);
    RenderParams params = make_params(flat, kReferenceWidth, kReferenceHeight,
                                      {.sampler = kSamplerIndependent,
                                       .bounces = c.max_bounces,
                                       .energy_compensation = false,
                                       .filter = PixelFilter::box});
    const auto filter = make_filter_table(PixelFilter::box);
    const std::size_t count = std::size_t(3) * kReferenceWidth * kReferenceHeight;
    std::vector<double> sum(count), squares(count);
    const std::atomic<bool> cancel{false};
    for (int r = 0; r < kReplicates; ++r) {
        params.seed = std::uint32_t(r) + 1;
        Film film({0, 0, kReferenceWidth, kReferenceHeight});
        RenderCounters counters;
        EXPECT_TRUE(renderer.begin({c.camera, params, filter}, film));
        EXPECT_TRUE(renderer.render(0, samples, counters, cancel));
        EXPECT_EQ(counters.non_finite.load(), 0u);
        for (std::size_t i = 0; i < count; ++i) {
            const PixelSum& pixel = film.sums[i / 3];
            const double value = double(pixel.radiance[int(i % 3)]) / double(pixel.weight);
            sum[i] += value;
            squares[i] += value * value;
        }
    }
    return estimate(kReferenceWidth, kReferenceHeight, kReplicates, sum, squares);
}

std::string describe(const Scale& s) {
    return fmt::format("{}: {:+.2f} standard errors, {:+.3f} %, p {:.2g}", s.where, s.z,
                       100 * s.relative, s.p_value);
}

// Renders and compares; writes the differences next to the test if they are too unlikely.
void expect_reference(const std::string& name, const ReferenceCase& c, std::uint32_t samples) {
    const Estimate reference = read_reference(name);
    const Estimate ours = render(c, samples);
    const Comparison result = compare(ours, reference);
    fmt::print("{}: standard error of the mean {:.3f} %\n  {}\n  {}\n  {}\n", name,
               100 * result.picture_error, describe(result.picture), describe(result.blocks),
               describe(result.pixels));
    EXPECT_GT(result.picture.p_value, kLevel) << describe(result.picture);
    EXPECT_GT(result.blocks.p_value, kLevel) << describe(result.blocks);
    EXPECT_GT(result.pixels.p_value, kLevel) << describe(result.pixels);
    if (!testing::Test::HasFailure()) return;
    for (const bool in_errors : {false, true}) {
        const std::filesystem::path path = std::filesystem::absolute(
            name + (in_errors ? "_difference_in_errors.exr" : "_difference.exr"));
        if (write_exr(path, difference_image(ours, reference, in_errors), false, {}))
            ADD_FAILURE() << "ours - reference" << (in_errors ? " in standard errors" : "")
                          << " is in " << path;
    }
}

TEST(Reference, StudentTail) {
    // Closed forms for one and two degrees of freedom, and the normal limit.
    EXPECT_NEAR(student_tail(1, 1), 0.5, 1e-9);
    EXPECT_NEAR(student_tail(3, 2), 1 - 3 / std::sqrt(11.0), 1e-9);
    EXPECT_NEAR(student_tail(-4, 1e7) / std::erfc(4 / std::sqrt(2.0)), 1, 1e-4);
}

TEST(Reference, Box) {
    expect_reference("box", reference_box(), 32);
}

TEST(Reference, Metal) {
    expect_reference("metal", reference_metal(), 32);
}

TEST(Reference, Materials) {
    expect_reference("materials", reference_materials(), 32);
}

TEST(Reference, Punctual) {
    expect_reference("punctual", reference_punctual(), 32);
}

TEST(Reference, Lens) {
    expect_reference("lens", reference_lens(), 32);
}

TEST(Reference, Transparency) {
    expect_reference("transparency", reference_transparency(), 32);
}

}  // namespace
}  // namespace hm::test
