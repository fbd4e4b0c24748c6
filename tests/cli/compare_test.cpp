// `himalaya compare`: the numbers in its JSON against closed forms, its messages about pictures
// that differ in size, layers or kind, and the exit codes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/compare.h"
#include "base/json_document.h"
#include "image/layers.h"
#include "image/read.h"
#include "image/test_images.h"
#include "image/write.h"

namespace {

using namespace hm;
using namespace hm::cli;
using namespace hm::testing_images;

constexpr int kWidth = 16, kHeight = 12;

std::vector<float> filled(float value, std::size_t channels) {
    return std::vector<float>(kWidth * kHeight * channels, value);
}

class Compare : public ::testing::Test {
  protected:
    LayeredImage picture(float value) {
        LayeredImage p;
        p.data = p.display = {0, 0, kWidth, kHeight};
        p.layers.push_back(make_layer("", "RGB", filled(value, 3)));
        return p;
    }

    std::filesystem::path write(const char* name, const LayeredImage& p) {
        const auto written = write_layers(folder_ / name, p);
        EXPECT_TRUE(written) << written.error().line();
        return folder_ / name;
    }

    // The exit code; what is printed goes to `printed_`.
    ExitCode run(const CompareOptions& options) {
        testing::internal::CaptureStdout();
        const Result<ExitCode> code = compare(options);
        printed_ = testing::internal::GetCapturedStdout();
        error_ = code ? "" : code.error().line();
        return code ? *code : exit_code(code.error().kind);
    }

    CompareOptions pair(const LayeredImage& a, const LayeredImage& b) {
        CompareOptions options;
        options.test = write("a.exr", a);
        options.reference = write("b.exr", b);
        options.json = true;
        return options;
    }

    const Json& document() {
        document_ = JsonDocument::parse(printed_, "printed").value();
        return document_->root();
    }

    Json layer(std::size_t index = 0) {
        return document().at("/layers/" + std::to_string(index)).value();
    }

    double number(std::string_view key, std::size_t index = 0) {
        return layer(index).real(key).value().value();
    }

    bool is_null(std::string_view key) {
        return layer().at("/" + std::string(key)).value().type() == JsonType::null;
    }

    Folder folder_;
    std::optional<JsonDocument> document_;
    std::string printed_, error_;
};

TEST_F(Compare, NumbersOfFlatPictures) {
    EXPECT_EQ(run(pair(picture(0.5f), picture(0.25f))), ExitCode::ok);
    EXPECT_NEAR(number("rmse"), 0.25, 1e-9);
    EXPECT_NEAR(number("relmse"), 0.0625 / (0.0625 + 0.01), 1e-8);
    EXPECT_EQ(layer().text("name").value(), "beauty");
    EXPECT_GT(number("flip"), 0.0);
    EXPECT_GT(number("psnr"), 0.0);
    EXPECT_GT(number("ssim"), 0.0);
    // The exposure that shows a flat 0.25 as middle grey.
    EXPECT_NEAR(number("display_exposure"), std::log2(0.18 / 0.25), 1e-6);

    EXPECT_EQ(run(pair(picture(0.5f), picture(0.5f))), ExitCode::ok);
    EXPECT_EQ(number("flip"), 0.0);
    EXPECT_NEAR(number("ssim"), 1.0, 1e-6);
    EXPECT_TRUE(is_null("psnr"));  // infinite
}

TEST_F(Compare, LimitsDecideTheExitCode) {
    CompareOptions options = pair(picture(0.5f), picture(0.25f));
    options.max_rmse = 0.26f;
    EXPECT_EQ(run(options), ExitCode::ok);
    options.max_rmse = 0.24f;
    EXPECT_EQ(run(options), ExitCode::different);
    EXPECT_NE(printed_.find("beauty: RMSE is 0.25, above 0.24"), std::string::npos) << printed_;
    options.max_rmse.reset();
    options.max_flip = 0.0f;
    EXPECT_EQ(run(options), ExitCode::different);
    options.max_flip = 1.0f;
    options.max_relmse = 0.5f;
    EXPECT_EQ(run(options), ExitCode::different);
}

TEST_F(Compare, NotFiniteIsNamed) {
    LayeredImage a = picture(0.5f), b = picture(0.5f);
    a.layers[0].channels[1].values[3] = std::nanf("");
    a.layers[0].channels[2].values[4] = std::numeric_limits<float>::infinity();
    b.layers[0].channels[0].values[4] = -std::numeric_limits<float>::infinity();
    CompareOptions options = pair(a, b);
    EXPECT_EQ(run(options), ExitCode::ok);
    EXPECT_EQ(layer().at("/not_finite").value().integer("test").value(), 2u);
    EXPECT_EQ(layer().at("/not_finite").value().integer("reference").value(), 1u);
    EXPECT_EQ(number("rmse"), 0.0);
    EXPECT_EQ(number("flip"), 0.0);
    options.max_flip = 1.0f;
    EXPECT_EQ(run(options), ExitCode::different);
    options.json = false;
    run(options);
    EXPECT_NE(printed_.find("2 pixels of " + options.test.string() + " are not finite"),
              std::string::npos)
        << printed_;
}

TEST_F(Compare, SizesAndWindowsAreNamed) {
    LayeredImage small = picture(1);
    small.data = small.display = {0, 0, kHeight, kWidth};
    EXPECT_EQ(run(pair(picture(1), small)), ExitCode::invalid);
    EXPECT_NE(error_.find("is 16 x 12 pixels, but"), std::string::npos) << error_;
    EXPECT_NE(error_.find("b.exr is 12 x 16 pixels"), std::string::npos) << error_;
    LayeredImage moved = picture(1);
    moved.data = {5, 0, 5 + kWidth, kHeight};
    EXPECT_EQ(run(pair(picture(1), moved)), ExitCode::invalid);
    EXPECT_NE(error_.find("from 5,0 on"), std::string::npos) << error_;
}

TEST_F(Compare, LayersAreNamed) {
    LayeredImage a = picture(0.5f), b = picture(0.5f);
    a.layers.push_back(make_layer("depth", "Z", filled(3, 1)));
    b.layers.push_back(make_layer("depth", "Z", filled(5, 1)));
    a.layers.push_back(make_layer("albedo", "RGB", filled(0.5f, 3)));
    CompareOptions options = pair(a, b);
    options.layers = {"depth"};
    EXPECT_EQ(run(options), ExitCode::ok);
    EXPECT_EQ(number("rmse"), 2.0);
    EXPECT_TRUE(is_null("flip"));  // depth has no colours
    options.layers = {"albedo"};
    EXPECT_EQ(run(options), ExitCode::invalid);
    EXPECT_NE(error_.find("b.exr: has no layer \"albedo\"; there are beauty, depth"),
              std::string::npos)
        << error_;
    options.layers = {"albedo=beauty"};
    EXPECT_EQ(run(options), ExitCode::ok);
    EXPECT_EQ(layer().text("name").value(), "albedo=beauty");
    EXPECT_EQ(number("rmse"), 0.0);
    options.layers = {"all"};
    EXPECT_EQ(run(options), ExitCode::different);
    EXPECT_EQ(document().texts("only_in_test").value().at(0), "albedo");
    EXPECT_EQ(number("rmse", 1), 2.0);
}

TEST_F(Compare, KindsDoNotMix) {
    CompareOptions options = pair(picture(1), picture(1));
    Image8 image(kWidth, kHeight);
    ASSERT_TRUE(write_png(folder_ / "c.png", image, false, {}));
    options.reference = folder_ / "c.png";
    EXPECT_EQ(run(options), ExitCode::invalid);
    EXPECT_NE(error_.find("linear values, but"), std::string::npos) << error_;
    options.test = folder_ / "d.png";
    for (Rgba<std::uint8_t>& pixel : image.pixels)
        pixel[1] = 51;
    ASSERT_TRUE(write_png(options.test, image, false, {}));
    EXPECT_EQ(run(options), ExitCode::ok);
    EXPECT_NEAR(number("psnr"), -10 * std::log10(0.2 * 0.2 / 3), 1e-5);
    EXPECT_EQ(document().text("flip_kind").value(), "LDR");
}

TEST_F(Compare, TheErrorAsAPicture) {
    LayeredImage a = picture(0.5f);
    a.layers[0].channels[0].values[1] = std::nanf("");
    CompareOptions options = pair(a, picture(0.25f));
    options.error_picture = folder_ / "error.exr";
    options.error_metric = ErrorMetric::rmse;
    ASSERT_EQ(run(options), ExitCode::ok);
    const FloatImage numbers = read_whole<float>(bytes_of_file(options.error_picture));
    ASSERT_FALSE(numbers.pixels.empty());
    EXPECT_EQ(numbers.pixels[0][0], 0.25f);
    EXPECT_TRUE(std::isnan(numbers.pixels[1][0]));
    options.error_picture = folder_ / "error.png";
    options.error_metric = ErrorMetric::flip;
    ASSERT_EQ(run(options), ExitCode::ok);
    const Image8 colors = read_whole<std::uint8_t>(bytes_of_file(options.error_picture));
    ASSERT_FALSE(colors.pixels.empty());
    EXPECT_EQ(colors.pixels[1][1], 255);  // green: NaN
    EXPECT_GT(colors.pixels[0][0], 0);
}

TEST_F(Compare, VarianceLayersGiveAZTest) {
    LayeredImage a = picture(0.5f), b = picture(0.5f);
    for (LayerChannel& channel : a.layers[0].channels)
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            channel.values[i] += i % 2 == 0 ? 0.1f : -0.1f;
    CompareOptions options = pair(a, b);
    options.z_test = true;
    EXPECT_EQ(run(options), ExitCode::invalid);  // no variance
    EXPECT_NE(error_.find("variance"), std::string::npos) << error_;
    for (LayeredImage* p : {&a, &b})
        p->layers.push_back(make_layer("variance", "RGB", filled(0.01f, 3)));
    options = pair(a, b);
    options.z_test = true;
    EXPECT_EQ(run(options), ExitCode::ok);
    EXPECT_TRUE(layer().at("/z_test").value().flag("agree").value());
    for (LayerChannel& channel : a.layers[0].channels)
        for (float& value : channel.values)
            value += 0.1f;
    options = pair(a, b);
    EXPECT_EQ(run(options), ExitCode::ok);  // reported, no limit
    EXPECT_FALSE(layer().at("/z_test").value().flag("agree").value());
    options.z_test = true;
    EXPECT_EQ(run(options), ExitCode::different);
}

}  // namespace
