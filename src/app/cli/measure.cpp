#include "app/cli/measure.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "compare/error_map.h"
#include "compare/ssim.h"
#include "output/tonemap.h"
#include "shading/math.h"

namespace hm::cli {
namespace {

using Mask = std::vector<bool>;

// Channels in the same order on both sides.
using Channels = std::vector<std::pair<const LayerChannel*, const LayerChannel*>>;

bool is_color(const Layer& layer) {
    return layer.find("R") && layer.find("G") && layer.find("B");
}

// The channels that count: R, G and B if they exist, else all.
Channels channels_of(const LayerPair& pair) {
    Channels channels;
    const bool color = is_color(pair.reference);
    for (const LayerChannel& channel : pair.reference.channels) {
        const bool counts =
            !color || channel.name == "R" || channel.name == "G" || channel.name == "B";
        if (counts) channels.emplace_back(pair.test.find(channel.name), &channel);
    }
    return channels;
}

std::uint64_t find_broken(const Channels& channels, bool test, Mask& finite) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < finite.size(); ++i) {
        bool good = true;
        for (const auto& [a, b] : channels)
            good = good && std::isfinite((test ? a : b)->values[i]);
        if (good) continue;
        finite[i] = false;
        ++count;
    }
    return count;
}

ImageError stored_error(const Channels& channels, const Mask& finite) {
    std::vector<float> a, b;
    for (const auto& [test, reference] : channels)
        for (std::size_t i = 0; i < finite.size(); ++i) {
            if (!finite[i]) continue;
            a.push_back(test->values[i]);
            b.push_back(reference->values[i]);
        }
    return a.empty() ? ImageError{} : compare_values(a, b);
}

// Black in place of NaN and infinity, so that filters work.
FloatImage color_image(const LayeredImage& file, const Layer& layer, const Mask& finite) {
    FloatImage image = layer_image(file, layer);
    for (std::size_t i = 0; i < finite.size(); ++i)
        if (!finite[i]) std::fill_n(image.pixels[i].begin(), 3, 0.0f);
    return image;
}

template <class Convert>
FloatImage converted(FloatImage image, Convert convert) {
    for (Rgba<float>& pixel : image.pixels) {
        const vec3 color = convert(vec3(pixel[0], pixel[1], pixel[2]));
        pixel = {color.x, color.y, color.z, pixel[3]};
    }
    return image;
}

Plane luma(const FloatImage& image) {
    const auto planes = color_planes(image);
    Plane out(image.width, image.height);
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] =
            luminance(vec3(planes[0].values[i], planes[1].values[i], planes[2].values[i]));
    return out;
}

double mean_where(const Plane& plane, const Mask& counts) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (counts[i]) {
            sum += double(plane.values[i]);
            ++count;
        }
    return count > 0 ? sum / count : 0;
}

vec3 decoded(vec3 c) {
    return vec3(srgb_to_linear(c.x), srgb_to_linear(c.y), srgb_to_linear(c.z));
}

void measure_colors(const LayerPair& pair, const Mask& finite, std::optional<ErrorMetric> picture,
                    LayerError& error) {
    const FloatImage a = color_image(pair.test_file, pair.test, finite);
    const FloatImage b = color_image(pair.reference_file, pair.reference, finite);
    Plane flip;
    if (pair.encoded) {
        flip = ldr_flip(converted(b, decoded), converted(a, decoded));
    } else {
        error.hdr = hdr_flip(b, a);
        flip = std::move(error.hdr.error);
    }
    error.flip = mean_where(flip, finite);

    FloatImage shown_a = a, shown_b = b;
    if (!pair.encoded) {
        error.display_exposure = double(auto_exposure(b));
        const float scale = float(std::exp2(error.display_exposure));
        const auto show = [scale](vec3 c) {
            return linear_to_srgb3(tone_map(max(c, vec3(0.0f)) * scale, kToneNeutral));
        };
        shown_a = converted(a, show);
        shown_b = converted(b, show);
    }
    error.psnr_db = psnr(compare_images(shown_a, shown_b).mse);
    error.ssim = ssim(luma(shown_a), luma(shown_b));

    const Layer* variance_a = pair.test_file.find("variance");
    const Layer* variance_b = pair.reference_file.find("variance");
    if (!pair.encoded && pair.test.name.empty() && variance_a && variance_b)
        error.z_test = z_test(a, layer_image(pair.test_file, *variance_a), b,
                              layer_image(pair.reference_file, *variance_b));
    if (picture == ErrorMetric::flip) error.picture = std::move(flip);
}

}  // namespace

std::string shown_name(const Layer& layer) {
    return layer.name.empty() ? "beauty" : layer.name;
}

LayerError measure(const LayerPair& pair, std::optional<ErrorMetric> picture) {
    LayerError error;
    error.name = shown_name(pair.test);
    if (pair.test.name != pair.reference.name)
        error.name.append("=").append(shown_name(pair.reference));
    const Channels channels = channels_of(pair);
    Mask finite(pair.reference_file.data.pixels(), true);
    error.not_finite_test = find_broken(channels, true, finite);
    error.not_finite_reference = find_broken(channels, false, finite);
    error.stored = stored_error(channels, finite);
    if (is_color(pair.reference)) {
        const LayerChannel* const alpha_a = pair.test.find("A");
        const LayerChannel* const alpha_b = pair.reference.find("A");
        if (alpha_a && alpha_b) error.alpha_rmse = stored_error({{alpha_a, alpha_b}}, finite).rmse;
        measure_colors(pair, finite, picture, error);
    }
    if (picture == ErrorMetric::rmse || picture == ErrorMetric::relmse) {
        const FloatImage a = layer_image(pair.test_file, pair.test);
        const FloatImage b = layer_image(pair.reference_file, pair.reference);
        error.picture =
            picture == ErrorMetric::rmse ? absolute_error(a, b) : relative_squared_error(a, b);
    }
    if (!error.picture.values.empty())
        for (std::size_t i = 0; i < finite.size(); ++i)
            if (!finite[i]) error.picture.values[i] = std::nanf("");
    return error;
}

}  // namespace hm::cli
