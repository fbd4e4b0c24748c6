#include "output/layers.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "film/variance.h"

namespace hm {
namespace {

// Interleaved values of one AOV, computed from the sums in its plane.
std::vector<float> finish_plane(const Film& film, const AovInfo& info) {
    const FilmPlane& plane = *film.find_plane(info.plane);
    const std::size_t channels = info.channels.size();
    const float nothing = info.aov == Aov::depth ? kDepthOfNothing : 0.0f;
    std::vector<float> values;
    values.reserve(film.sums.size() * channels);
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        const float* sums = &plane.values[i * plane.floats];
        const float divisor = info.value == AovValue::mean       ? film.sums[i].weight
                              : info.value == AovValue::hit_mean ? sums[channels]
                                                                 : 1.0f;
        for (std::size_t c = 0; c < channels; ++c)
            values.push_back(divisor > 0 ? sums[c] / divisor : nothing);
    }
    return values;
}

// Adds A: 1 if a ray hit, else 0. Blender misreads a layer that has only U and V.
void add_hit_channel(const Film& film, const AovInfo& info, Layer& layer) {
    const FilmPlane& plane = *film.find_plane(info.plane);
    LayerChannel& hit = layer.channels.emplace_back();
    hit.name = "A";
    for (std::size_t i = 0; i < film.sums.size(); ++i)
        hit.values.push_back(plane.values[(i + 1) * plane.floats - 1] > 0 ? 1.0f : 0.0f);
}

// Positions are summed relative to the scene's origin, in floats, so that the sums stay precise.
std::vector<float> finish_positions(const Film& film, const AovInfo& info,
                                    const glm::dvec3& origin) {
    std::vector<float> values = finish_plane(film, info);
    if (origin == glm::dvec3(0)) return values;
    const FilmPlane& plane = *film.find_plane(info.plane);
    for (std::size_t i = 0; i < film.sums.size(); ++i) {
        if (!(plane.values[i * plane.floats + 3] > 0)) continue;  // no sample hit anything
        for (std::size_t c = 0; c < 3; ++c)
            values[3 * i + c] = float(origin[glm::length_t(c)] + double(values[3 * i + c]));
    }
    return values;
}

std::vector<Layer> light_group_layers(const Film& film) {
    const FilmPlane& plane = *film.find_plane(kPlaneLightGroups);
    std::vector<Layer> layers;
    std::vector<float> values(3 * film.sums.size());
    for (std::size_t g = 0; g < film.selection.light_groups.size(); ++g) {
        for (std::size_t i = 0; i < film.sums.size(); ++i)
            for (std::size_t c = 0; c < 3; ++c) {
                const float sum = plane.values[i * plane.floats + 3 * g + c];
                values[3 * i + c] = film.sums[i].weight > 0 ? sum / film.sums[i].weight : 0.0f;
            }
        layers.push_back(make_layer(
            fmt::format("{}_{}", aov_info(Aov::light_groups).layer, film.selection.light_groups[g]),
            "RGB", values));
    }
    return layers;
}

std::vector<float> sample_counts(const Film& film) {
    std::vector<float> counts;
    counts.reserve(film.sums.size());
    for (const PixelSum& sum : film.sums)
        counts.push_back(sum.weight);
    return counts;
}

std::vector<Layer> layers_of(const Film& film, const AovInfo& info, const LayerChoice& choice) {
    const std::string layer(info.layer);
    switch (info.value) {
        case AovValue::ids:
            return cryptomatte_layers(film, info.aov, choice.names);
        case AovValue::own:
            break;
        default: {
            Layer made =
                make_layer(layer, info.channels,
                           info.aov == Aov::position ? finish_positions(film, info, choice.origin)
                                                     : finish_plane(film, info));
            if (info.aov == Aov::uv) add_hit_channel(film, info, made);
            return {std::move(made)};
        }
    }
    if (info.aov == Aov::light_groups) return light_group_layers(film);
    return {make_layer(layer, info.channels,
                       info.aov == Aov::samples ? sample_counts(film) : variance_of_means(film))};
}

void store_as_half(std::vector<Layer>& layers) {
    for (Layer& layer : layers)
        for (LayerChannel& channel : layer.channels)
            channel.type = ChannelType::half;
}

}  // namespace

LayeredImage film_layers(const Film& film, const LayerChoice& choice) {
    const auto is_half = [&](std::string_view name) {
        return std::find(choice.half.begin(), choice.half.end(), name) != choice.half.end();
    };
    LayeredImage picture;
    picture.data = {int(film.crop.x0), int(film.crop.y0), int(film.crop.x1), int(film.crop.y1)};
    picture.display = {0, 0, int(choice.width), int(choice.height)};
    picture.layers = {make_layer("", film.resolve(), choice.alpha)};
    if (is_half("beauty")) store_as_half(picture.layers);
    for (const Aov aov : film.selection.aovs) {
        const AovInfo& info = aov_info(aov);
        std::vector<Layer> layers = layers_of(film, info, choice);
        if (is_half(info.name)) store_as_half(layers);
        std::move(layers.begin(), layers.end(), std::back_inserter(picture.layers));
        if (info.value != AovValue::ids) continue;
        const Metadata more = cryptomatte_metadata(aov, choice.names);
        picture.metadata.insert(picture.metadata.end(), more.begin(), more.end());
    }
    return picture;
}

tl::expected<std::vector<std::string>, std::string> parse_half(std::string_view text) {
    std::string fit = "beauty, ";
    std::vector<std::string> all = {"beauty"}, chosen;
    for (const AovInfo& info : all_aovs()) {
        if (!info.half) continue;
        all.emplace_back(info.name);
        fit += std::string(info.name) + ", ";
    }
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const std::string name(text.substr(at, end - at));
        at = end + 1;
        if (name == "all")
            chosen = all;
        else if (std::find(all.begin(), all.end(), name) != all.end())
            chosen.push_back(name);
        else
            return tl::unexpected(fmt::format(
                "\"{}\" is not one of the layers that can be stored in 16 bits: {}all", name, fit));
    }
    return chosen;
}

}  // namespace hm
