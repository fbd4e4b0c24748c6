// What renderers hand their samples to: sums per pixel, and the picture they make. Sums, never
// averages, so that a film can be stored, gone on with, and joined with others. All of its data
// are `sums`, `planes` and `ids`.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "film/aov.h"
#include "image/image.h"
#include "shading/path/types.h"

namespace hm {

// Half-open, in pixels of the whole picture.
struct PixelRect {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::uint32_t width() const { return x1 - x0; }
    std::uint32_t height() const { return y1 - y0; }
    bool operator==(const PixelRect&) const = default;
};

// One of the planes that shading/path/aov_planes.h lists.
struct FilmPlane {
    std::uint32_t plane;    // kPlane*
    std::string_view name;  // unique within a film
    std::uint32_t floats;   // per pixel, next to each other
    PlaneMerge merge;
    std::vector<float> values;  // rows of crop.width() pixels
};

// How many of a pixel's samples hit one surface. `id` numbers the geometries of all instances
// (scene/surface_names.h): object, material and asset follow from it.
struct IdCount {
    std::uint32_t id;
    float count;
};

// Ordered by id, so that equal pixels have equal lists whatever came first.
using IdList = std::vector<IdCount>;
void add_id(IdList& list, std::uint32_t id, float count);

struct Film {
    PixelRect crop;
    // A pixel holds samples first_sample, first_sample + 1, ... as many as its weight says.
    std::uint32_t first_sample = 0;
    AovSelection selection;
    std::vector<PixelSum> sums;     // rows of crop.width()
    std::vector<FilmPlane> planes;  // what `selection` needs, in the order of their numbers
    std::vector<IdList> ids;        // one per pixel where a cryptomatte is chosen, else empty

    explicit Film(PixelRect rect, AovSelection chosen = {});

    // Null where the selection does not need it.
    const FilmPlane* find_plane(std::uint32_t plane) const;
    FilmPlane* find_plane(std::uint32_t plane);

    // Premultiplied; a pixel without samples is black and transparent.
    FloatImage resolve() const;
    // Mean luminance that clamping took from a pixel, and the mean that is left.
    double removed_luminance() const;
    double mean_luminance() const;
    double mean_samples() const;
    std::uint32_t fewest_samples() const;
    std::uint32_t most_samples() const;
};

// Adds the samples of `part`, which has others of the same picture: same crop and selection, no
// sample twice. In whatever order parts are added, the result is the same to float rounding, and
// in the end, when no sample is missing in between, a film as any other.
void merge_film(Film& film, const Film& part);

}  // namespace hm
