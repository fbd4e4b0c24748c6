// Histogram bins over directions wi for microfacet lobes of any width: by the slope of the half
// vector with wo, logarithmic away from the peak, and by its azimuth.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "shading/lang.h"

namespace hm::test {

class HalfVectorGrid {
  public:
    static constexpr int kRings = 36;
    static constexpr int kSectors = 16;
    static constexpr int kBins = kRings * kSectors;

    HalfVectorGrid(vec3 wo, float alpha)
        : wo_(glm::normalize(glm::dvec3(wo))),
          alpha_(double(alpha)),
          reach_(std::asinh(kSteepest / alpha_)) {}

    // The bin of a direction above the horizon.
    std::size_t bin(vec3 wi) const {
        glm::dvec3 h = glm::normalize(wo_ + glm::normalize(glm::dvec3(wi)));
        double slope = std::sqrt(h.x * h.x + h.y * h.y) / std::max(h.z, 1e-12);
        double y = std::asinh(slope / alpha_) / reach_;
        double phi = std::atan2(h.y, h.x) / (2 * std::numbers::pi);
        int ring = std::clamp(int(y * kRings), 0, kRings - 1);
        int sector = std::clamp(int((phi - std::floor(phi)) * kSectors), 0, kSectors - 1);
        return std::size_t(ring * kSectors + sector);
    }

    // Integrates pdf(wi, h), a density per solid angle of wi, over the part of each bin above the
    // horizon. Midpoint rule with steps^2 points per bin.
    template <class Pdf>
    std::vector<double> integrate(int steps, Pdf&& pdf) const {
        std::vector<double> shares(kBins);
        for (int ring = 0; ring < kRings; ++ring)
            for (int i = 0; i < steps; ++i) {
                double y = (ring + (i + 0.5) / steps) / kRings;
                double slope = alpha_ * std::sinh(y * reach_);
                double slope_dy = alpha_ * std::cosh(y * reach_) * reach_;
                double hz = 1 / std::sqrt(1 + slope * slope);
                for (int j = 0; j < kSectors * steps; ++j) {
                    double phi = 2 * std::numbers::pi * (j + 0.5) / (kSectors * steps);
                    glm::dvec3 h(slope * hz * std::cos(phi), slope * hz * std::sin(phi), hz);
                    double cos_d = glm::dot(wo_, h);
                    glm::dvec3 wi = 2 * cos_d * h - wo_;
                    if (cos_d <= 0 || wi.z <= 0) continue;
                    // dwi = 4 cos_d dh, dh = hz^3 d(slopes), in polar coordinates.
                    double area = 4 * cos_d * hz * hz * hz * slope * slope_dy *
                                  (1.0 / (kRings * steps)) *
                                  (2 * std::numbers::pi / (kSectors * steps));
                    shares[std::size_t(ring * kSectors + j / steps)] +=
                        area * double(pdf(vec3(wi), vec3(h)));
                }
            }
        return shares;
    }

  private:
    static constexpr double kSteepest = 200;  // slope; steeper ones go into the last ring
    glm::dvec3 wo_;
    double alpha_;
    double reach_;
};

}  // namespace hm::test
