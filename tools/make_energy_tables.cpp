// Writes a table of src/shading/material/energy.h: directional albedos, by quadrature in double at
// the nodes.
//
//     make_energy_tables sheen > src/shading/tables/sheen_albedo.inl
//     make_energy_tables glass > src/shading/tables/glass_albedo.inl
//     make_energy_tables anisotropic > src/shading/tables/anisotropic_albedo.inl
//
// sheen: of white sheen, which a few entries take above 1. glass: what a rough boundary reflects
// and lets through in one scattering event, entering and leaving the denser medium. anisotropic:
// GGX split by Schlick's Fresnel into f0 * x + f90 * y.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

#include "shading/material/fresnel.h"
#include "shading/material/sheen.h"
#include "shading/structs.h"

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLeastRoughness = 0.04;  // of materials, kMinRoughness

struct Vec {
    double x, y, z;
};

double dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double stretched(Vec w, double ax, double ay) {
    return std::sqrt(ax * ax * w.x * w.x + ay * ay * w.y * w.y + w.z * w.z);
}

double node(std::size_t i, std::size_t count) {
    return double(i) / double(count - 1);
}

// Directions at grazing angles keep a cosine: none of the lobes is defined at 0.
Vec view(double root, double sin2_azimuth) {
    const double z = std::max(root * root, 1e-4), s = std::sqrt(1 - z * z);
    return {s * std::sqrt(1 - sin2_azimuth), s * std::sqrt(sin2_azimuth), z};
}

// Calls visit(normal, weight) over visible normals: even steps of the polar
// angle of the cap and of the azimuth, weights summing to 1.
template <class Visit>
void for_each_visible_normal(Vec wo, double ax, double ay, int steps, const Visit& visit) {
    const double size = stretched(wo, ax, ay);
    const Vec w{ax * wo.x / size, ay * wo.y / size, wo.z / size};
    const double widest = std::acos(-w.z);
    double total = 0;
    for (int i = 0; i < steps; ++i)
        total += std::sin(widest * (i + 0.5) / steps);
    for (int i = 0; i < steps; ++i) {
        const double theta = widest * (i + 0.5) / steps;
        const double s = std::sin(theta), weight = s / (total * 2 * steps);
        for (int j = 0; j < 2 * steps; ++j) {
            const double phi = kPi * (j + 0.5) / steps;
            Vec h{ax * (s * std::cos(phi) + w.x), ay * (s * std::sin(phi) + w.y),
                  std::cos(theta) + w.z};
            const double length = std::sqrt(dot(h, h));
            h = {h.x / length, h.y / length, h.z / length};
            visit(h, weight);
        }
    }
}

// G2 / G1, height-correlated: of leaving towards wi having come from wo.
double passed(Vec wo, Vec wi, double ax, double ay) {
    const double lo = stretched(wo, ax, ay), li = stretched(wi, ax, ay);
    const double ci = std::abs(wi.z);
    return ci * (wo.z + lo) / (ci * lo + wo.z * li);
}

Vec mirrored(Vec wo, Vec h) {
    const double d = 2 * dot(wo, h);
    return {d * h.x - wo.x, d * h.y - wo.y, d * h.z - wo.z};
}

void print(double x, double y, std::size_t i) {
    fmt::print("{:.6e}f, {:.6e}f,{}", x, y, i % 4 == 3 ? "\n" : " ");
}

void print_anisotropic() {
    std::size_t at = 0;
    for (std::size_t s = 0; s < hm::kAnisotropyStrengths; ++s)
        for (std::size_t r = 0; r < hm::kAnisotropyRows; ++r)
            for (std::size_t a = 0; a < hm::kAnisotropyAzimuths; ++a)
                for (std::size_t c = 0; c < hm::kAnisotropyColumns; ++c) {
                    const double strength = node(s, hm::kAnisotropyStrengths);
                    const double roughness =
                        std::max(node(r, hm::kAnisotropyRows), kLeastRoughness);
                    const double ay = roughness * roughness;
                    const double ax = ay + (1 - ay) * strength * strength;
                    const Vec wo =
                        view(node(c, hm::kAnisotropyColumns), node(a, hm::kAnisotropyAzimuths));
                    double sum = 0, grazing = 0;
                    for_each_visible_normal(wo, ax, ay, 96, [&](Vec h, double weight) {
                        const Vec wi = mirrored(wo, h);
                        if (wi.z <= 0) return;
                        const double g = weight * passed(wo, wi, ax, ay);
                        sum += g;
                        grazing += g * std::pow(std::max(0.0, 1 - dot(wo, h)), 5);
                    });
                    print(sum - grazing, grazing, at++);
                }
}

// What a rough boundary reflects and lets through; eta as in shading/material/fresnel.h.
void print_glass_entry(double eta, double roughness, double root, std::size_t at) {
    const double alpha = std::pow(std::max(roughness, kLeastRoughness), 2);
    const Vec wo = view(root, 0);
    double reflected = 0, refracted = 0;
    for_each_visible_normal(wo, alpha, alpha, 128, [&](Vec h, double weight) {
        const double cos_o = std::min(dot(wo, h), 1.0);
        const double sin2 = (1 - cos_o * cos_o) / (eta * eta);
        double f = 1, cos_t = 0;
        if (sin2 < 1) {
            cos_t = std::sqrt(1 - sin2);
            const double rs = (cos_o - eta * cos_t) / (cos_o + eta * cos_t);
            const double rp = (eta * cos_o - cos_t) / (eta * cos_o + cos_t);
            f = (rs * rs + rp * rp) / 2;
        }
        const Vec up = mirrored(wo, h);
        if (up.z > 0) reflected += weight * f * passed(wo, up, alpha, alpha);
        const double k = cos_o / eta - cos_t;
        const Vec down{h.x * k - wo.x / eta, h.y * k - wo.y / eta, h.z * k - wo.z / eta};
        if (f < 1 && down.z < 0) refracted += weight * (1 - f) * passed(wo, down, alpha, alpha);
    });
    print(reflected, refracted, at);
}

void print_glass() {
    std::size_t at = 0;
    for (const bool leaving : {false, true})
        for (std::size_t n = 0; n < hm::kGlassIndices; ++n)
            for (std::size_t r = 0; r < hm::kGlassRows; ++r)
                for (std::size_t c = 0; c < hm::kGlassColumns; ++c) {
                    const double root = 0.6 * node(n, hm::kGlassIndices);  // of the reflectance
                    const double ior = (1 + root) / (1 - root);
                    print_glass_entry(leaving ? 1 / ior : ior, node(r, hm::kGlassRows),
                                      node(c, hm::kGlassColumns), at++);
                }
}

// Over the hemisphere, denser towards the horizon, where fibres reflect: z = t^3.
double sheen_albedo(double roughness, double root) {
    constexpr int kSteps = 192;
    const Vec v = view(root, 0);
    const hm::vec3 wo(float(v.x), float(v.y), float(v.z));
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = (i + 0.5) / kSteps, z = t * t * t, s = std::sqrt(1 - z * z);
        for (int j = 0; j < kSteps; ++j) {
            const double phi = kPi * (j + 0.5) / kSteps;
            const hm::vec3 wi(float(s * std::cos(phi)), float(s * std::sin(phi)), float(z));
            sum += double(hm::eval_sheen(wo, wi, float(roughness))) * z * 3 * t * t;
        }
    }
    return sum * 2 * kPi / (double(kSteps) * kSteps);
}

void print_sheen() {
    std::size_t at = 0;
    for (std::size_t r = 0; r < hm::kSheenRows; ++r)
        for (std::size_t c = 0; c < hm::kSheenColumns; ++c) {
            const double least = double(hm::kMinSheenRoughness);
            const double roughness = least + (1 - least) * node(r, hm::kSheenRows);
            const double albedo = sheen_albedo(roughness, node(c, hm::kSheenColumns));
            fmt::print("{:.6e}f,{}", albedo, ++at % 8 == 0 ? "\n" : " ");
        }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view name = argc == 2 ? argv[1] : "";
    if (name != "sheen" && name != "glass" && name != "anisotropic") {
        fmt::print(stderr, "usage: make_energy_tables sheen|glass|anisotropic\n");
        return 2;
    }
    fmt::print("// Directional albedos. Written by tools/make_energy_tables {}.\n", name);
    if (name == "sheen") print_sheen();
    if (name == "glass") print_glass();
    if (name == "anisotropic") print_anisotropic();
    return 0;
}
