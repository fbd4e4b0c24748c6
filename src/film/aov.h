// The AOVs (arbitrary output variables): what a picture can carry beside the beauty, how each is
// called, and which of the film's planes it is made from. docs/aovs.md explains them to users.
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

// What the final write makes of a pixel's sums.
enum class AovValue {
    mean,      // over all samples
    hit_mean,  // over those that hit; the plane's last float counts them
    first,     // of the lowest sample index that hit; the plane's last float holds it
    ids,       // cryptomatte, from the pixel's list of ids
    own        // light groups, sample count and variance have rules of their own
};

struct AovInfo {
    Aov aov;
    std::string_view name;      // as --aov has it
    std::string_view layer;     // in the file
    std::string_view channels;  // one letter each
    AovValue value;
    std::uint32_t plane;  // kPlane*; kNone where no plane of floats is needed
    bool half;            // whether 16 bits may hold it
};

// In the order of the enumeration.
std::span<const AovInfo> all_aovs();
const AovInfo& aov_info(Aov aov);

// How the planes of two films join, pixel by pixel.
enum class PlaneMerge {
    add,
    lowest  // the one whose last float, a sample index + 1, is lower and not 0
};

// What a film is asked to carry. Two films join only if theirs are equal.
struct AovSelection {
    std::vector<Aov> aovs;                  // in the table's order, none twice
    std::vector<std::string> light_groups;  // names, where Aov::light_groups is chosen
    bool sample_variance = false;           // of samples (independent ones), not of replicates

    bool has(Aov aov) const;
    bool wants_ids() const;  // any cryptomatte
    // Whether anything is chosen that the renderer has to work for.
    bool needs_planes() const;
    bool operator==(const AovSelection&) const = default;
};

// "albedo,depth", or "all" but the variance, which alone changes the beauty: "all,variance" is
// every one. The error completes a sentence and lists the names.
tl::expected<std::vector<Aov>, std::string> parse_aovs(std::string_view text);
// What parse_aovs reads; empty for none.
std::string aov_names(std::span<const Aov> aovs);

}  // namespace hm
