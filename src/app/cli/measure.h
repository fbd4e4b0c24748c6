// The distance between two layers, by every applicable metric.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/choice.h"
#include "compare/flip.h"
#include "compare/metrics.h"
#include "compare/z_test.h"
#include "image/layers.h"
#include "image/plane.h"

namespace hm::cli {

enum class ErrorMetric { flip, rmse, relmse };
inline constexpr Choice<ErrorMetric> kErrorMetrics[] = {
    {"flip", ErrorMetric::flip}, {"rmse", ErrorMetric::rmse}, {"relmse", ErrorMetric::relmse}};

// Two layers of one size and with the same channels.
struct LayerPair {
    const LayeredImage& test_file;
    const Layer& test;
    const LayeredImage& reference_file;
    const Layer& reference;
    bool encoded = false;  // sRGB in [0, 1], else linear
};

struct LayerError {
    std::string name;  // as for --layer; "beauty" for the unnamed layer
    // Pixels with a NaN or infinite value, excluded from the metrics below.
    std::uint64_t not_finite_test = 0, not_finite_reference = 0;

    ImageError stored;  // of the stored values; of alpha only if there is no R, G, B
    std::optional<double> alpha_rmse;

    // Of colours only. PSNR and SSIM compare display colours: linear ones are mapped by the neutral
    // tone curve at the exposure that `--exposure auto` finds for the reference.
    std::optional<double> psnr_db, ssim, flip;
    double display_exposure = 0;  // EV; linear colours only
    HdrFlip hdr;                  // the exposures of an HDR-FLIP
    std::optional<ZTest> z_test;

    Plane picture;  // the requested error map, empty if none
};

std::string shown_name(const Layer& layer);

// `picture`: the metric to make an error picture of, if any.
LayerError measure(const LayerPair& pair, std::optional<ErrorMetric> picture);

}  // namespace hm::cli
