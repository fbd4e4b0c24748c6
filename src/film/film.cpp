#include "film/film.h"

#include <span>

#include "shading/math.h"

namespace hm {

Film::Film(PixelRect rect)
    : crop(rect), sums(std::size_t(rect.width()) * rect.height(), PixelSum{}) {}

Image Film::resolve() const {
    std::vector<vec4> pixels;
    pixels.reserve(sums.size());
    for (const PixelSum& s : sums)
        pixels.push_back(s.weight > 0 ? vec4(s.radiance, s.alpha) / s.weight : vec4(0));
    std::span<const std::byte> bytes = std::as_bytes(std::span(pixels));
    return {crop.width(), crop.height(), PixelFormat::rgba32f, {bytes.begin(), bytes.end()}};
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

}  // namespace hm
