// The BSDF of materials with extensions: energy is kept, sampling agrees with quadrature that knows
// nothing of it, refraction is reciprocal, and thin films have the colour of a spectral
// computation.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "support/hosts.h"
#include "support/statistics.h"

namespace hm {
namespace {

using test::direction;
using test::ExtendedHost;

constexpr double kPi = std::numbers::pi;

ExtendedPoint plain() {
    ExtendedPoint p{};
    p.specular_color = vec3(1);
    p.specular = 1;
    p.ior = 1.5f;
    p.anisotropy_direction = vec2(1, 0);
    p.iridescence_ior = 1.3f;
    return p;
}

struct Look {
    std::string name;
    ExtendedPoint point;
    float metallic = 0;
    float eta = 1.5f;
    bool thin = true;
    double tolerance = 0.01;
};

// Every lobe alone, and what meets in real files.
std::vector<Look> looks() {
    std::vector<Look> all;
    const auto add = [&](std::string name, auto change) {
        Look look{std::move(name), plain()};
        change(look);
        all.push_back(std::move(look));
    };
    add("plain", [](Look&) {});
    add("metal", [](Look& l) { l.metallic = 1; });
    add("metal under film", [](Look& l) {
        l.metallic = 1;
        l.point.iridescence = 1;
        l.point.iridescence_thickness = 420;
    });
    add("coat", [](Look& l) {
        l.point.clearcoat = 1;
        l.point.clearcoat_roughness = 0.4f;
    });
    add("sheen", [](Look& l) {
        l.point.sheen_color = vec3(1);
        l.point.sheen_roughness = 0.5f;
    });
    add("sheen, smooth, under rough coat", [](Look& l) {
        l.point.sheen_color = vec3(0.9f);
        l.point.clearcoat = 0.7f;
        l.point.clearcoat_roughness = 0.6f;
    });
    // Between the nodes of the table, where the albedo bends.
    add("brushed metal", [](Look& l) {
        l.metallic = 1;
        l.point.anisotropy = 0.8f;
        l.tolerance = 0.02;
    });
    add("bright dielectric", [](Look& l) { l.point.ior = 2.4f; });
    add("diffuse transmission", [](Look& l) {
        l.point.diffuse_transmission = 0.4f;
        l.point.diffuse_transmission_color = vec3(1);
    });
    add("thin glass", [](Look& l) { l.point.transmission = 1; });
    // The glass table's interpolation over index and cosine.
    add("glass from outside", [](Look& l) {
        l.point.transmission = 1;
        l.thin = false;
        l.tolerance = 0.015;
    });
    add("glass from inside", [](Look& l) {
        l.point.transmission = 1;
        l.thin = false;
        l.eta = 1 / 1.5f;
        l.tolerance = 0.02;
    });
    add("half glass under coat and film", [](Look& l) {
        l.point.transmission = 0.5f;
        l.point.clearcoat = 0.5f;
        l.point.clearcoat_roughness = 0.3f;
        l.point.iridescence = 0.6f;
        l.point.iridescence_thickness = 300;
        l.tolerance = 0.015;
    });
    return all;
}

constexpr float kRoughnesses[] = {0.0f, 0.08f, 0.25f, 0.5f, 0.75f, 1.0f};
constexpr float kCosines[] = {0.05f, 0.15f, 0.4f, 0.7f, 1.0f};

ExtendedHost::ExtendedBsdf make(ExtendedHost& host, const Look& look, float roughness, vec3 wo,
                                vec3 color = vec3(1)) {
    ExtendedHost::ExtendedBsdf b;
    host.make_extended_bsdf({color, look.metallic, roughness, 1}, look.point, wo, vec3(0, 0, 1),
                            look.eta, look.thin, b);
    return b;
}

// Directional albedo by the material's own sampling, over points of the R4 lattice.
double sampled_albedo(ExtendedHost& host, const ExtendedHost::ExtendedBsdf& b, vec3 wo, int count) {
    double sum = 0;
    const auto lattice = [](double step, int i) {
        const double x = 0.5 + step * i;
        return float(x - std::floor(x));
    };
    for (int i = 0; i < count; ++i) {
        const bool far = lattice(0.8566748838545029, i) < b.transmits;
        ExtendedHost::ExtendedSample s;
        host.sample_extended(b, far, wo, lattice(0.7338918566271260, i),
                             lattice(0.6287067210378087, i), lattice(0.5385972572236101, i), s);
        if (s.pdf > 0 && (s.wi.z < 0) == far) sum += double(s.weight.y);
    }
    return sum / count;
}

TEST(Extended, WhiteMaterialsKeepAllLight) {
    ExtendedHost host(true);
    for (const Look& look : looks())
        for (float roughness : kRoughnesses)
            for (float cos_o : kCosines) {
                const vec3 wo = direction(cos_o, 0.3f);
                const auto b = make(host, look, roughness, wo);
                // The lattice leaves up to 3e-3 of the steepest lobes, sheen at grazing angles.
                EXPECT_NEAR(sampled_albedo(host, b, wo, 1 << 15), 1, look.tolerance + 3e-3)
                    << look.name << ", roughness " << roughness << ", cos " << cos_o;
            }
}

TEST(Extended, NothingGainsLightWhateverItsColours) {
    ExtendedHost host(true);
    test::Random random(151);
    for (int i = 0; i < 300; ++i) {
        Look look{"random", plain()};
        ExtendedPoint& p = look.point;
        p.specular = random.unit();
        p.specular_color = vec3(random.unit(), random.unit(), random.unit()) * 2.0f;
        p.ior = random.between(1, 2.5f);
        p.clearcoat = i % 2 == 0 ? random.unit() : 0;
        p.clearcoat_roughness = random.unit();
        p.sheen_color = i % 3 == 0 ? vec3(random.unit(), 0.5f, random.unit()) : vec3(0);
        p.sheen_roughness = random.unit();
        p.anisotropy = i % 5 == 0 ? random.unit() : 0;
        p.iridescence = i % 4 == 0 ? random.unit() : 0;
        p.iridescence_thickness = random.between(0, 1200);
        p.transmission = i % 3 == 1 ? random.unit() : 0;
        p.diffuse_transmission = random.unit();
        p.diffuse_transmission_color = vec3(random.unit());
        look.metallic = i % 2 == 0 ? random.unit() : 0;
        look.thin = i % 7 != 0;
        look.eta = i % 2 == 0 ? p.ior : 1 / p.ior;
        const float roughness = random.unit(), cos_o = random.between(0.02f, 1);
        const vec3 wo = direction(cos_o, random.between(0, 6));
        const auto b = make(host, look, roughness, wo, vec3(random.unit()));
        const double albedo = sampled_albedo(host, b, wo, 4096);
        EXPECT_TRUE(std::isfinite(albedo)) << i;
        EXPECT_GE(albedo, 0) << i;
        EXPECT_LT(albedo, 1.03) << i << ": roughness " << roughness << ", cos " << cos_o;
    }
}

// The mean of a test function over sampled directions against its integral with eval_extended on a
// grid that is uniform in solid angle; both of one side.
TEST(Extended, SamplingAgreesWithQuadrature) {
    constexpr int kSteps = 600, kSamples = 1 << 17;
    ExtendedHost host(true);
    const auto probe = [](vec3 w) { return 0.5 + double(w.x) * 0.3 - double(w.y) * 0.2; };
    for (const Look& look : looks())
        for (float roughness : {0.4f, 0.8f})
            for (float cos_o : {0.3f, 0.9f}) {
                const vec3 wo = direction(cos_o, 0.3f);
                const auto b = make(host, look, roughness, wo, vec3(0.7f));
                for (bool far : {false, true}) {
                    if ((far ? b.transmits : 1 - b.transmits) <= 0) continue;
                    double grid = 0, density = 0;
                    for (int i = 0; i < kSteps; ++i)
                        for (int j = 0; j < kSteps; ++j) {
                            const float z = (float(i) + 0.5f) / kSteps;
                            const vec3 wi = direction(far ? -z : z, float(j) * 6.2831853f / kSteps);
                            vec3 diffuse;
                            float pdf;
                            const vec3 f = host.eval_extended(b, far, wo, wi, diffuse, pdf);
                            grid += double(f.y) * probe(wi);
                            density += double(pdf);
                        }
                    grid *= 2 * kPi / (double(kSteps) * kSteps);
                    density *= 2 * kPi / (double(kSteps) * kSteps);
                    double sum = 0, inside = 0, squares = 0;
                    test::Random random(152);
                    for (int i = 0; i < kSamples; ++i) {
                        ExtendedHost::ExtendedSample s;
                        const float lobe = random.unit(), u = random.unit(), v = random.unit();
                        host.sample_extended(b, far, wo, lobe, u, v, s);
                        if (!(s.pdf > 0) || (s.wi.z < 0) != far) continue;
                        const double value = double(s.weight.y) * probe(s.wi);
                        sum += value;
                        squares += value * value;
                        inside += 1;
                    }
                    const double mean = sum / kSamples;
                    const double deviation =
                        std::sqrt((squares / kSamples - mean * mean) / kSamples);
                    const std::string at = look.name + ", roughness " + std::to_string(roughness) +
                                           ", cos " + std::to_string(cos_o) +
                                           (far ? ", far side" : ", near side");
                    // Midpoints of 600 x 600 leave 2e-3 of the narrowest of these lobes.
                    EXPECT_NEAR(mean, grid, 4.5 * deviation + 2e-3 * std::abs(grid)) << at;
                    const double share = inside / kSamples;
                    EXPECT_NEAR(share, density,
                                4.5 * std::sqrt(share * (1 - share) / kSamples) + 2e-3 * density)
                        << at;
                }
            }
}

// Of basic radiance, f(wo, wi) / n_t^2 = f(wi, wo) / n_o^2 (Veach 1997, 5.2).
TEST(Extended, RefractionIsReciprocal) {
    test::Random random(153);
    int compared = 0;
    for (int i = 0; i < 20000; ++i) {
        const float eta = random.between(1.1f, 2.4f);
        const vec2 alpha(random.between(0.05f, 1), random.between(0.05f, 1));
        const vec3 wo = direction(random.between(0.05f, 1), random.between(0, 6.28f));
        const vec3 wi = direction(-random.between(0.05f, 1), random.between(0, 6.28f));
        float pdf, cos_d;
        const double out = double(eval_refraction(wo, wi, alpha, eta, pdf, cos_d)) / -double(wi.z);
        // The same pair seen from below: the surface is turned over.
        const vec3 turned_wo(wi.x, wi.y, -wi.z), turned_wi(wo.x, wo.y, -wo.z);
        const double back =
            double(eval_refraction(turned_wo, turned_wi, alpha, 1 / eta, pdf, cos_d)) /
            double(wo.z);
        if (!(out > 1e-6)) continue;
        ++compared;
        EXPECT_NEAR(out / (double(eta) * double(eta)) / back, 1, 2e-3) << i;
    }
    EXPECT_GT(compared, 1000);
}

// CIE 1931, multi-lobe fit of Wyman, Sloan and Shirley (JCGT 2013), to linear Rec.709.
std::array<double, 3> rec709_of(double nm) {
    const auto lobe = [](double x, double mean, double low, double high) {
        const double t = (x - mean) / (x < mean ? low : high);
        return std::exp(-0.5 * t * t);
    };
    const double x = 1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                     0.065 * lobe(nm, 501.1, 20.4, 26.2);
    const double y = 0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1);
    const double z = 1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8);
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
            -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

// Airy's formula for one wavelength, both polarisations.
double airy(double film, double base, double thickness_nm, double cos_0, double nm) {
    const double sin_0 = std::sqrt(1 - cos_0 * cos_0);
    const double cos_1 = std::sqrt(1 - std::pow(sin_0 / film, 2));
    const double cos_2 = std::sqrt(1 - std::pow(sin_0 / base, 2));
    const auto s = [](double n1, double c1, double n2, double c2) {
        return (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    };
    const std::complex<double> turn = std::polar(1.0, 4 * kPi * film * thickness_nm * cos_1 / nm);
    const auto reflect = [&](double r1, double r2) {
        return std::norm((r1 + r2 * turn) / (1.0 + r1 * r2 * turn));
    };
    // For p, cosines and indices change places.
    return 0.5 * (reflect(s(1, cos_0, film, cos_1), s(film, cos_1, base, cos_2)) +
                  reflect(s(1, cos_1, film, cos_0), s(film, cos_2, base, cos_1)));
}

TEST(Extended, ThinFilmsHaveTheColourOfASpectralComputation) {
    double worst = 0;
    for (double thickness : {100.0, 250.0, 400.0, 550.0})
        for (double film : {1.3, 1.5, 1.8})
            for (double cosine : {1.0, 0.8, 0.5}) {
                const double base = 1.6, f0 = std::pow((base - 1) / (base + 1), 2);
                std::array<double, 3> color{}, white{};
                for (double nm = 380; nm < 780; nm += 1) {
                    const double r = airy(film, base, thickness, cosine, nm);
                    const auto response = rec709_of(nm);
                    for (std::size_t k = 0; k < 3; ++k) {
                        color[k] += r * response[k];
                        white[k] += response[k];
                    }
                }
                const vec3 ours = thin_film_fresnel(float(film), float(thickness), vec3(float(f0)),
                                                    float(cosine));
                for (std::size_t k = 0; k < 3; ++k) {
                    const double error = std::abs(double(ours[int(k)]) - color[k] / white[k]);
                    worst = std::max(worst, error);
                    EXPECT_LT(error, 0.025) << thickness << " nm, " << film << ", cos " << cosine;
                }
            }
    RecordProperty("largest_error", std::to_string(worst));
}

// A film on nothing (the lens of SunglassesKhronos: ior 1): its reflection must be drawn, though
// the boundary without the film reflects nothing. The near side's mean is the film's reflectance.
TEST(Extended, FilmsOnAirReflect) {
    ExtendedHost host(true);
    Look look{"film", plain()};
    look.point.transmission = 1;
    look.point.ior = look.eta = 1;
    look.point.iridescence = 1;
    look.point.iridescence_ior = 2;
    look.point.iridescence_thickness = 300;
    const vec3 wo = direction(0.8f, 0.3f);
    const auto b = make(host, look, 0, wo);
    const vec3 exact = thin_film_fresnel(2, 300, vec3(0), 0.8f);
    EXPECT_GT(exact.y, 0.05f);
    ExtendedHost::ExtendedSample s;
    host.sample_extended(b, false, wo, 0.5f, 0.5f, 0.5f, s);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(s.weight[k] * (1 - b.transmits), exact[k], 1e-3f);
}

TEST(Extended, AFilmThatVanishesLeavesItsBase) {
    const vec3 f0(0.04f, 0.5f, 0.9f);
    const vec3 f = thin_film_fresnel(1.3f, 0, f0, 0.7f);
    const float grazing = std::pow(0.3f, 5.0f);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(f[k], f0[k] + (1 - f0[k]) * grazing, 2e-3f);
}

}  // namespace
}  // namespace hm
