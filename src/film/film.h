// The film accumulates samples: it holds sums per pixel and resolves them to a picture. It stores
// sums, not averages, so that it can be saved, continued and merged with other films. All pixel
// data are in `sums`, `planes` and `ids`.
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

// One of the planes listed in shading/path/aov_planes.h.
struct FilmPlane {
    std::uint32_t plane;    // kPlane*
    std::string_view name;  // unique within a film
    std::uint32_t floats;   // per pixel, contiguous
    PlaneMerge merge;
    std::vector<float> values;  // rows of crop.width() pixels
};

// The number of samples of a pixel that hit one surface. `id` numbers the geometries of all
// instances (scene/surface_names.h); it determines object, material and asset.
struct IdCount {
    std::uint32_t id;
    float count;
};

// Sorted by id, so that the list does not depend on the order of the samples.
using IdList = std::vector<IdCount>;
void add_id(IdList& list, std::uint32_t id, float count);

struct Film {
    PixelRect crop;
    // A pixel holds samples first_sample, first_sample + 1, ...; its weight is their number.
    std::uint32_t first_sample = 0;
    AovSelection selection;
    std::vector<PixelSum> sums;     // rows of crop.width()
    std::vector<FilmPlane> planes;  // required by `selection`, sorted by number
    std::vector<IdList> ids;        // one per pixel if a cryptomatte is selected, else empty

    explicit Film(PixelRect rect, AovSelection chosen = {});

    // Null if the selection does not need the plane.
    const FilmPlane* find_plane(std::uint32_t plane) const;
    FilmPlane* find_plane(std::uint32_t plane);

    // Premultiplied; a pixel without samples is black and transparent.
    FloatImage resolve() const;
    // Means over pixels of the luminance that clamping removed, and of the luminance that is left.
    double removed_luminance() const;
    double mean_luminance() const;
    double mean_samples() const;
    std::uint32_t fewest_samples() const;
    std::uint32_t most_samples() const;
};

// Adds the samples of `part`, a film of the same picture with the same crop and selection and with
// different samples. The result does not depend on the order of the parts, except for float
// rounding. It is an ordinary film once no sample is missing in between.
void merge_film(Film& film, const Film& part);

}  // namespace hm
