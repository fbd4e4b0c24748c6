// The planes that a selection requires, and merging: films of parts of the samples give the film of
// all samples in any order. Values are small multiples of a power of two, which floats add without
// rounding, so that equality is exact.
#include "film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "shading/rng.h"

namespace hm {
namespace {

AovSelection everything() {
    AovSelection s;
    s.aovs = *parse_aovs("all,variance");
    s.light_groups = {"lamp", "environment"};
    return s;
}

// Adds one sample, a function of pixel and index. A third of the samples hit nothing.
void add_test_sample(Film& film, std::size_t pixel, std::uint32_t index) {
    const auto value = [&](std::uint32_t k) {
        return float(hash_combine(hash_combine(std::uint32_t(pixel), index), k) % 64u) * 0.25f;
    };
    PixelSum& sum = film.sums[pixel];
    sum.radiance += vec3(value(0), value(1), value(2));
    sum.alpha += 1;
    sum.weight += 1;
    const bool hit = hash_combine(std::uint32_t(pixel), index) % 3u != 0u;
    for (FilmPlane& plane : film.planes) {
        float* values = plane.values.data() + pixel * plane.floats;
        float& last = values[plane.floats - 1];
        const bool lower = hit && (last == 0 || float(index + 1) < last);
        for (std::uint32_t c = 0; c < plane.floats; ++c) {
            if (plane.merge == PlaneMerge::add)
                values[c] += value(10 * plane.plane + c);
            else if (lower)
                values[c] = value(10 * plane.plane + c);
        }
        if (plane.merge == PlaneMerge::lowest && lower) last = float(index + 1);
    }
    if (hit && !film.ids.empty()) add_id(film.ids[pixel], std::uint32_t(value(7)), 1);
}

constexpr PixelRect kCrop{3, 2, 8, 6};

Film film_of(std::uint32_t begin, std::uint32_t end) {
    Film film(kCrop, everything());
    for (std::size_t pixel = 0; pixel < film.sums.size(); ++pixel)
        for (std::uint32_t i = begin; i < end; ++i)
            add_test_sample(film, pixel, i);
    return film;
}

void expect_equal(const Film& a, const Film& b) {
    EXPECT_EQ(std::memcmp(a.sums.data(), b.sums.data(), a.sums.size() * sizeof(PixelSum)), 0);
    ASSERT_EQ(a.planes.size(), b.planes.size());
    for (std::size_t i = 0; i < a.planes.size(); ++i)
        EXPECT_EQ(a.planes[i].values, b.planes[i].values) << a.planes[i].name;
    ASSERT_EQ(a.ids.size(), b.ids.size());
    for (std::size_t i = 0; i < a.ids.size(); ++i) {
        ASSERT_EQ(a.ids[i].size(), b.ids[i].size()) << i;
        for (std::size_t k = 0; k < a.ids[i].size(); ++k) {
            EXPECT_EQ(a.ids[i][k].id, b.ids[i][k].id);
            EXPECT_EQ(a.ids[i][k].count, b.ids[i][k].count);
        }
    }
}

TEST(Film, PlanesFollowTheSelection) {
    const Film plain({0, 0, 4, 4});
    EXPECT_TRUE(plain.planes.empty());
    EXPECT_TRUE(plain.ids.empty());

    AovSelection some;
    some.aovs = *parse_aovs("depth,samples,albedo");
    const Film film(kCrop, some);
    ASSERT_EQ(film.planes.size(), 2u);
    EXPECT_EQ(film.planes[0].name, "albedo");
    EXPECT_EQ(film.planes[0].values.size(), 5u * 4u * 3u);
    EXPECT_EQ(film.find_plane(kPlaneDepth)->floats, 2u);
    EXPECT_EQ(film.find_plane(kPlaneUv), nullptr);
    EXPECT_TRUE(film.ids.empty());

    const Film all(kCrop, everything());
    EXPECT_EQ(all.find_plane(kPlaneLightGroups)->floats, 6u);
    EXPECT_EQ(all.find_plane(kPlaneReplicates)->floats, 4u * kReplicates);
    EXPECT_EQ(all.find_plane(kPlaneSquares), nullptr);
    EXPECT_EQ(all.ids.size(), 20u);
    AovSelection independent = everything();
    independent.sample_variance = true;
    EXPECT_EQ(Film(kCrop, independent).find_plane(kPlaneReplicates), nullptr);
    EXPECT_EQ(Film(kCrop, independent).find_plane(kPlaneSquares)->floats, 3u);
}

TEST(Film, PartsMergeInAnyOrder) {
    const Film whole = film_of(0, 24);
    const std::vector<Film> parts = {film_of(0, 5), film_of(5, 6), film_of(6, 17), film_of(17, 24)};
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0u);
    do {
        Film film(kCrop, everything());
        for (const std::size_t i : order)
            merge_film(film, parts[i]);
        expect_equal(film, whole);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Film, MergingIsAssociative) {
    Film left = film_of(0, 8), right = film_of(8, 16);
    const Film last = film_of(16, 24);
    merge_film(right, last);
    merge_film(left, right);
    expect_equal(left, film_of(0, 24));
}

TEST(Film, EmptyPartsChangeNothing) {
    Film film = film_of(3, 9);
    merge_film(film, Film(kCrop, everything()));
    expect_equal(film, film_of(3, 9));
}

TEST(Aov, NamesAreParsed) {
    EXPECT_EQ(parse_aovs("all,variance")->size(), all_aovs().size());
    EXPECT_EQ(parse_aovs("variance,all"), parse_aovs("all,variance"));
    // "all" leaves the beauty unchanged.
    AovSelection all{*parse_aovs("all"), {}, false};
    EXPECT_EQ(all.aovs.size() + 1, all_aovs().size());
    EXPECT_FALSE(all.has(Aov::variance));
    const std::vector<Aov> both = {Aov::albedo, Aov::normal};
    EXPECT_EQ(*parse_aovs("normal,albedo,normal"), both);
    for (const char* text : {"", "albedo,", "Albedo", "albedo normal"}) {
        const auto parsed = parse_aovs(text);
        ASSERT_FALSE(parsed) << text;
        EXPECT_NE(parsed.error().find("not one of albedo, metallic"), std::string::npos);
    }
}

TEST(Aov, NamesAreUnique) {
    for (const AovInfo& a : all_aovs())
        for (const AovInfo& b : all_aovs())
            EXPECT_EQ(a.name == b.name || a.layer == b.layer, &a == &b) << a.name;
}

}  // namespace
}  // namespace hm
