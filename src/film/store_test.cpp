// Films in files: reading restores every bit, damage is detected, and parts can be merged in any
// order.
#include "film/store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <span>
#include <string>

#include "base/files.h"

namespace hm {
namespace {

namespace fs = std::filesystem;

class FilmStore : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "film_test-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string error_of(const fs::path& path) {
        const auto read = read_film(path);
        return read ? "" : read.error().line();
    }

    fs::path folder_;
};

AovSelection everything() {
    AovSelection selection;
    selection.aovs = *parse_aovs("all,variance");
    selection.light_groups = {"sun", "the lamp, \"left\"", "a\nb"};
    return selection;
}

// Adds `count` random samples to each pixel. Their magnitudes vary widely, so that any rounding
// shows.
void add_samples(Film& film, std::uint32_t first, std::uint32_t count, unsigned seed) {
    std::mt19937 numbers(seed);
    std::lognormal_distribution<float> value(0, 3);
    film.first_sample = first;
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        PixelSum& sum = film.sums[i];
        for (std::uint32_t n = 0; n < count; ++n) {
            sum.radiance += vec3(value(numbers), value(numbers), value(numbers));
            sum.alpha += 1;
            sum.weight += 1;
            sum.removed += value(numbers) * 1e-3f;
            for (FilmPlane& plane : film.planes)
                for (std::uint32_t f = 0; f < plane.floats; ++f) {
                    float& at = plane.values[i * plane.floats + f];
                    if (plane.merge == PlaneMerge::add)
                        at += value(numbers);
                    else if (n == 0)
                        at = f + 1 == plane.floats ? float(first + 1) : value(numbers);
                }
            if (!film.ids.empty())
                add_id(film.ids[i], std::uint32_t(numbers() % 5) * 0x1fffffffu, 1);
        }
    }
}

void expect_same_bits(const Film& a, const Film& b) {
    EXPECT_EQ(a.crop, b.crop);
    EXPECT_EQ(a.first_sample, b.first_sample);
    EXPECT_EQ(a.selection, b.selection);
    ASSERT_EQ(a.sums.size(), b.sums.size());
    EXPECT_EQ(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(PixelSum)), 0);
    ASSERT_EQ(a.planes.size(), b.planes.size());
    for (std::size_t p = 0; p < a.planes.size(); ++p) {
        ASSERT_EQ(a.planes[p].values.size(), b.planes[p].values.size());
        EXPECT_EQ(std::memcmp(a.planes[p].values.data(), b.planes[p].values.data(),
                              a.planes[p].values.size() * sizeof(float)),
                  0)
            << a.planes[p].name;
    }
    ASSERT_EQ(a.ids.size(), b.ids.size());
    for (std::size_t i = 0; i < a.ids.size(); ++i) {
        ASSERT_EQ(a.ids[i].size(), b.ids[i].size()) << i;
        EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(a.ids[i])),
                                       std::as_bytes(std::span(b.ids[i]))))
            << i;
    }
}

TEST_F(FilmStore, ReadingRestoresEveryBit) {
    for (const bool with_aovs : {false, true})
        for (const ExrCompression compression : {ExrCompression::none, ExrCompression::zip}) {
            Film film({3, 2, 20, 13}, with_aovs ? everything() : AovSelection{});
            add_samples(film, 7, 5, 1);
            film.sums[0].radiance.x = std::numeric_limits<float>::infinity();
            film.sums[1].radiance.y = std::numeric_limits<float>::denorm_min();
            film.sums[2].radiance.z = -0.0f;
            if (with_aovs) {
                film.ids[4].clear();
                film.ids[5] = {{0, 1}, {1, 2}, {0x7f800001, 3}, {0xffffffff, 4}};  // NaN as floats
            }
            const FilmLabel label{64, 48, {{"b", "two\nlines"}, {"a", "one"}, {"empty", ""}}};
            const fs::path path = folder_ / "film.exr";
            ASSERT_TRUE(write_film(path, film, label, compression));
            const auto read = read_film(path);
            ASSERT_TRUE(read) << read.error().line();
            expect_same_bits(read->film, film);
            EXPECT_EQ(read->label.width, 64u);
            EXPECT_EQ(read->label.height, 48u);
            EXPECT_EQ(read->label.notes, (Metadata{{"a", "one"}, {"b", "two\nlines"}}));
        }
}

TEST_F(FilmStore, StoredBytesPredictTheFileSize) {
    Film film({0, 0, 200, 100}, AovSelection{*parse_aovs("albedo,depth"), {}, false});
    const fs::path path = folder_ / "film.exr";
    ASSERT_TRUE(write_film(path, film, {200, 100, {}}, ExrCompression::none));
    const double size = double(fs::file_size(path));
    EXPECT_NEAR(double(stored_bytes(film)) / size, 1, 0.01);
}

// If a bit is flipped or the file is truncated, the file is refused, or the film that is read
// equals the one written.
TEST_F(FilmStore, DamageIsDetected) {
    Film film({0, 0, 16, 8}, AovSelection{*parse_aovs("albedo,uv,crypto_object"), {}, false});
    add_samples(film, 0, 3, 2);
    const fs::path path = folder_ / "film.exr";
    ASSERT_TRUE(write_film(path, film, {16, 8, {{"note", "text"}}}, ExrCompression::none));
    const ByteArray bytes = *read_file(path);
    int refused = 0, harmless = 0;
    const auto check = [&](std::span<const std::byte> changed) {
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(changed.data()), std::ptrdiff_t(changed.size()));
        const auto read = read_film(path);
        if (!read) {
            EXPECT_EQ(read.error().file, path.string());
            ++refused;
            return;
        }
        expect_same_bits(read->film, film);
        EXPECT_EQ(read->label.notes, (Metadata{{"note", "text"}}));
        ++harmless;
    };
    std::mt19937 numbers(3);
    for (int i = 0; i < 300; ++i) {
        ByteArray changed = bytes;
        changed[numbers() % changed.size()] ^= std::byte(1u << numbers() % 8);
        check(changed);
    }
    for (int i = 0; i < 50; ++i)
        check(std::span(bytes).first(numbers() % bytes.size()));
    EXPECT_GT(refused, 250);
    // Chromaticities, pixel aspect ratio, and the offset table, which OpenEXR reconstructs.
    EXPECT_LT(harmless, 100);
}

TEST_F(FilmStore, OtherFilesAreRefused) {
    const fs::path path = folder_ / "film.exr";
    const std::string name = path.string();
    EXPECT_EQ(error_of(path), name + ": can't be opened: No such file or directory");
    LayeredImage picture{{0, 0, 2, 1}, {0, 0, 2, 1}, {}, {}};
    picture.layers.push_back(make_layer("", "RGB", std::vector<float>(6)));
    ASSERT_TRUE(write_layers(path, picture));
    EXPECT_EQ(error_of(path), name + ": is a picture, not a checkpoint or a part of a rendering");
    picture.metadata = {{"film.version", "2"}};
    ASSERT_TRUE(write_layers(path, picture));
    EXPECT_EQ(error_of(path), name + ": has version 2 of the format; this program has 1");
    EXPECT_EQ(read_film(path).error().kind, ErrorKind::unsupported);
    picture.metadata = {{"film.version", "1"}, {"film.first_sample", "0"}};
    ASSERT_TRUE(write_layers(path, picture));
    EXPECT_EQ(error_of(path), name + ": is damaged: channel sum.R is missing");
}

// Merging parts of random sizes in random order gives the whole film up to float rounding: sums of
// n terms of one sign differ by at most n roundings.
TEST_F(FilmStore, PartsMergeInAnyOrder) {
    constexpr std::uint32_t kSamples = 24;
    const PixelRect crop{0, 0, 7, 5};
    std::mt19937 numbers(4);
    Film whole(crop, everything());
    std::vector<Film> singles;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        add_samples(singles.emplace_back(crop, everything()), i, 1, 100 + i);
        if (i == 0)
            whole = singles[0];
        else
            merge_film(whole, singles[i]);
    }
    for (int round = 0; round < 20; ++round) {
        std::vector<Film> parts;
        for (std::uint32_t i = 0; i < kSamples;) {
            const std::uint32_t end = std::min<std::uint32_t>(i + 1 + numbers() % 8, kSamples);
            Film& part = parts.emplace_back(singles[i]);
            for (++i; i < end; ++i)
                merge_film(part, singles[i]);
        }
        std::shuffle(parts.begin(), parts.end(), numbers);
        Film joined = parts[0];
        for (std::size_t p = 1; p < parts.size(); ++p)
            merge_film(joined, parts[p]);
        const auto expect_near = [&](float a, float b) {
            EXPECT_LE(std::abs(a - b), std::abs(a) * kSamples * 0x1p-24f);
        };
        EXPECT_EQ(joined.first_sample, 0u);
        for (std::size_t i = 0; i < whole.sums.size(); ++i) {
            for (int c = 0; c < 3; ++c)
                expect_near(whole.sums[i].radiance[c], joined.sums[i].radiance[c]);
            EXPECT_EQ(whole.sums[i].weight, joined.sums[i].weight);
            expect_near(whole.sums[i].removed, joined.sums[i].removed);
            ASSERT_EQ(whole.ids[i].size(), joined.ids[i].size());
            for (std::size_t k = 0; k < whole.ids[i].size(); ++k) {
                EXPECT_EQ(whole.ids[i][k].id, joined.ids[i][k].id);
                EXPECT_EQ(whole.ids[i][k].count, joined.ids[i][k].count);
            }
        }
        for (std::size_t p = 0; p < whole.planes.size(); ++p)
            for (std::size_t i = 0; i < whole.planes[p].values.size(); ++i)
                expect_near(whole.planes[p].values[i], joined.planes[p].values[i]);
    }
}

}  // namespace
}  // namespace hm
