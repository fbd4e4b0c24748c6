#include "film/variance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace hm {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();

// `values`: kReplicates times (radiance, sample count).
float replicate_variance(const float* values, std::size_t channel) {
    double sum = 0, count = 0;
    int filled = 0;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        sum += double(values[4 * r + channel]);
        count += double(values[4 * r + 3]);
        filled += values[4 * r + 3] > 0 ? 1 : 0;
    }
    if (filled < int(kReplicates)) return kUnknown;
    double squares = 0;
    for (std::size_t r = 0; r < kReplicates; ++r) {
        const double n = double(values[4 * r + 3]);
        const double off = double(values[4 * r + channel]) / n - sum / count;
        squares += n * n * off * off;
    }
    return float(double(kReplicates) / (kReplicates - 1) * squares / (count * count));
}

float sample_variance(const PixelSum& sum, float squares, std::size_t channel) {
    const double n = double(sum.weight);
    if (n < 2) return kUnknown;
    const double mean = double(sum.radiance[channel]) / n;
    return float(std::max(double(squares) / n - mean * mean, 0.0) / (n - 1));
}

}  // namespace

std::vector<float> variance_of_means(const Film& film) {
    const FilmPlane* replicates = film.find_plane(kPlaneReplicates);
    const FilmPlane* squares = film.find_plane(kPlaneSquares);
    HM_CHECK(replicates || squares, "no variance plane among {} planes", film.planes.size());
    std::vector<float> variances;
    variances.reserve(3 * film.sums.size());
    for (std::size_t i = 0; i < film.sums.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            variances.push_back(
                replicates ? replicate_variance(&replicates->values[i * replicates->floats], c)
                           : sample_variance(film.sums[i], squares->values[3 * i + c], c));
    return variances;
}

std::optional<double> estimated_error(const Film& film) {
    if (!film.selection.has(Aov::variance) || film.sums.empty()) return std::nullopt;
    double sum = 0;
    const std::vector<float> variances = variance_of_means(film);
    for (const float v : variances)
        sum += double(v);
    if (!std::isfinite(sum)) return std::nullopt;
    return std::sqrt(sum / double(variances.size()));
}

}  // namespace hm
