// The AOVs (arbitrary output variables): the outputs that a picture can have in addition to the
// beauty, their names, and the film planes that they are computed from. User documentation:
// docs/aovs.md.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "shading/path/aov_planes.h"

namespace hm {

enum class Aov : std::uint32_t {
    albedo,
    metallic,
    roughness,
    normal,
    geometric_normal,
    depth,
    position,
    uv,
    emission,
    diffuse_direct,
    specular_direct,
    diffuse_indirect,
    specular_indirect,
    light_groups,
    motion,
    material_id,
    instance_id,
    crypto_object,
    crypto_material,
    crypto_asset,
    samples,
    variance
};

// How the final value of a pixel is computed from its sums.
enum class AovValue {
    mean,      // over all samples
    hit_mean,  // over the samples that hit; the plane's last float is their number
    first,     // of the lowest sample index that hit; the plane's last float is that index + 1
    ids,       // cryptomatte, from the pixel's list of ids
    own        // special cases: light groups, sample count and variance
};

struct AovInfo {
    Aov aov;
    std::string_view name;      // in --aov
    std::string_view layer;     // in the file
    std::string_view channels;  // one letter each
    AovValue value;
    std::uint32_t plane;  // kPlane*; kNone if no plane of floats is needed
    bool half;            // whether it may be stored as half
};

// In the order of the enumeration.
std::span<const AovInfo> all_aovs();
const AovInfo& aov_info(Aov aov);

// How the planes of two films are merged, pixel by pixel.
enum class PlaneMerge {
    add,
    lowest  // keep the pixel with the lower nonzero last float, which is a sample index + 1
};

// The AOVs of a film. Two films can be merged only if their selections are equal.
struct AovSelection {
    std::vector<Aov> aovs;                  // in the table's order, without duplicates
    std::vector<std::string> light_groups;  // names, if Aov::light_groups is selected
    bool sample_variance = false;  // Aov::variance is that of independent samples, not replicates

    bool has(Aov aov) const;
    bool wants_ids() const;  // any cryptomatte
    // Whether anything is selected that the renderer has to compute.
    bool needs_planes() const;
    bool operator==(const AovSelection&) const = default;
};

// Parses "albedo,depth". "all" means all but the variance, the only AOV that changes the beauty;
// "all,variance" is everything. The error message is a predicate and lists the names.
tl::expected<std::vector<Aov>, std::string> parse_aovs(std::string_view text);
// The inverse of parse_aovs; empty if there are no AOVs.
std::string aov_names(std::span<const Aov> aovs);

}  // namespace hm
