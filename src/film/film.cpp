#include "film/film.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "shading/math.h"
#include "shading/structs.h"

namespace hm {
namespace {

struct PlaneInfo {
    std::string_view name;
    std::uint32_t floats;
    PlaneMerge merge;
};

PlaneInfo plane_info(const AovInfo& aov, std::uint32_t plane, const AovSelection& selection) {
    const auto channels = std::uint32_t(aov.channels.size());
    switch (aov.value) {
        case AovValue::hit_mean:
            return {aov.name, channels + 1, PlaneMerge::add};
        case AovValue::first:
            return {aov.name, channels + 1, PlaneMerge::lowest};
        default:
            break;
    }
    if (plane == kPlaneLightGroups)
        return {aov.name, 3 * std::uint32_t(selection.light_groups.size()), PlaneMerge::add};
    if (plane == kPlaneReplicates) return {"replicates", 4 * kReplicates, PlaneMerge::add};
    if (plane == kPlaneSquares) return {"squares", 3, PlaneMerge::add};
    return {aov.name, channels, PlaneMerge::add};
}

std::vector<FilmPlane> make_planes(const AovSelection& selection, std::size_t pixels) {
    std::vector<FilmPlane> planes;
    for (const Aov aov : selection.aovs) {
        const AovInfo& info = aov_info(aov);
        if (info.plane == kNone) continue;
        const bool squares = aov == Aov::variance && selection.sample_variance;
        const std::uint32_t plane = squares ? kPlaneSquares : info.plane;
        const auto [name, floats, merge] = plane_info(info, plane, selection);
        planes.push_back({plane, name, floats, merge, std::vector<float>(pixels * floats)});
    }
    std::sort(planes.begin(), planes.end(),
              [](const FilmPlane& a, const FilmPlane& b) { return a.plane < b.plane; });
    return planes;
}

void merge_plane(FilmPlane& plane, const FilmPlane& part) {
    HM_CHECK(plane.plane == part.plane && plane.values.size() == part.values.size(),
             "{} with {} values, {} with {}", plane.name, plane.values.size(), part.name,
             part.values.size());
    if (plane.merge == PlaneMerge::add) {
        for (std::size_t i = 0; i < plane.values.size(); ++i)
            plane.values[i] += part.values[i];
        return;
    }
    for (std::size_t i = 0; i < plane.values.size(); i += plane.floats) {
        const float mine = plane.values[i + plane.floats - 1];
        const float other = part.values[i + plane.floats - 1];
        if (other > 0 && (mine == 0 || other < mine))
            std::copy_n(part.values.begin() + std::ptrdiff_t(i), plane.floats,
                        plane.values.begin() + std::ptrdiff_t(i));
    }
}

}  // namespace

void add_id(IdList& list, std::uint32_t id, float count) {
    const auto at = std::lower_bound(list.begin(), list.end(), id,
                                     [](const IdCount& a, std::uint32_t b) { return a.id < b; });
    if (at != list.end() && at->id == id)
        at->count += count;
    else
        list.insert(at, {id, count});
}

Film::Film(PixelRect rect, AovSelection chosen)
    : crop(rect),
      selection(std::move(chosen)),
      sums(std::size_t(rect.width()) * rect.height(), PixelSum{}),
      planes(make_planes(selection, sums.size())),
      ids(selection.wants_ids() ? sums.size() : 0) {}

const FilmPlane* Film::find_plane(std::uint32_t plane) const {
    for (const FilmPlane& p : planes)
        if (p.plane == plane) return &p;
    return nullptr;
}

FilmPlane* Film::find_plane(std::uint32_t plane) {
    return const_cast<FilmPlane*>(std::as_const(*this).find_plane(plane));
}

void merge_film(Film& film, const Film& part) {
    HM_CHECK(film.crop == part.crop && film.selection == part.selection,
             "{} and {} planes over {} and {} pixels", film.planes.size(), part.planes.size(),
             film.sums.size(), part.sums.size());
    film.first_sample = std::min(film.first_sample, part.first_sample);
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        PixelSum& sum = film.sums[i];
        const PixelSum& more = part.sums[i];
        sum.radiance += more.radiance;
        sum.alpha += more.alpha;
        sum.weight += more.weight;
        sum.removed += more.removed;
    }
    for (std::size_t p = 0; p < film.planes.size(); ++p)
        merge_plane(film.planes[p], part.planes[p]);
    for (std::size_t i = 0; i < film.ids.size(); ++i)
        for (const IdCount& entry : part.ids[i])
            add_id(film.ids[i], entry.id, entry.count);
}

FloatImage Film::resolve() const {
    FloatImage image(crop.width(), crop.height());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const PixelSum& s = sums[i];
        const vec4 mean = s.weight > 0 ? vec4(s.radiance, s.alpha) / s.weight : vec4(0);
        image.pixels[i] = {mean.x, mean.y, mean.z, mean.w};
    }
    return image;
}

double Film::removed_luminance() const {
    double sum = 0;
    for (const PixelSum& s : sums)
        sum += s.weight > 0 ? double(s.removed / s.weight) : 0.0;
    return sums.empty() ? 0 : sum / double(sums.size());
}

double Film::mean_luminance() const {
    double sum = 0;
    for (const PixelSum& s : sums)
        sum += s.weight > 0 ? double(luminance(s.radiance) / s.weight) : 0.0;
    return sums.empty() ? 0 : sum / double(sums.size());
}

double Film::mean_samples() const {
    double sum = 0;
    for (const PixelSum& s : sums)
        sum += double(s.weight);
    return sums.empty() ? 0 : sum / double(sums.size());
}

std::uint32_t Film::fewest_samples() const {
    float fewest = sums.empty() ? 0.0f : sums[0].weight;
    for (const PixelSum& s : sums)
        fewest = std::min(fewest, s.weight);
    return std::uint32_t(fewest);
}

std::uint32_t Film::most_samples() const {
    float most = 0;
    for (const PixelSum& s : sums)
        most = std::max(most, s.weight);
    return std::uint32_t(most);
}

}  // namespace hm
