#include "film/aov.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "shading/structs.h"

namespace hm {
namespace {

using enum AovValue;

// Layer names follow Arnold and Nuke (docs/aovs.md).
constexpr std::array kAovs = {
    AovInfo{Aov::albedo, "albedo", "albedo", "RGB", mean, kPlaneAlbedo, true},
    AovInfo{Aov::metallic, "metallic", "metallic", "Y", mean, kPlaneMetallic, true},
    AovInfo{Aov::roughness, "roughness", "roughness", "Y", mean, kPlaneRoughness, true},
    AovInfo{Aov::normal, "normal", "normal", "XYZ", mean, kPlaneNormal, true},
    AovInfo{Aov::geometric_normal, "geometric_normal", "geometric_normal", "XYZ", mean,
            kPlaneGeometricNormal, true},
    AovInfo{Aov::depth, "depth", "depth", "Z", hit_mean, kPlaneDepth, false},
    AovInfo{Aov::position, "position", "position", "XYZ", hit_mean, kPlanePosition, false},
    AovInfo{Aov::uv, "uv", "uv", "UV", first, kPlaneUv, true},
    AovInfo{Aov::emission, "emission", "emission", "RGB", mean, kPlaneEmission, true},
    AovInfo{Aov::diffuse_direct, "diffuse_direct", "diffuse_direct", "RGB", mean,
            kPlaneDiffuseDirect, true},
    AovInfo{Aov::specular_direct, "specular_direct", "specular_direct", "RGB", mean,
            kPlaneSpecularDirect, true},
    AovInfo{Aov::diffuse_indirect, "diffuse_indirect", "diffuse_indirect", "RGB", mean,
            kPlaneDiffuseIndirect, true},
    AovInfo{Aov::specular_indirect, "specular_indirect", "specular_indirect", "RGB", mean,
            kPlaneSpecularIndirect, true},
    AovInfo{Aov::light_groups, "light_groups", "light_group", "RGB", own, kPlaneLightGroups, true},
    AovInfo{Aov::motion, "motion", "forward", "uv", first, kPlaneMotion, true},
    AovInfo{Aov::material_id, "material_id", "material_id", "Y", first, kPlaneMaterialId, false},
    AovInfo{Aov::instance_id, "instance_id", "instance_id", "Y", first, kPlaneInstanceId, false},
    AovInfo{Aov::crypto_object, "crypto_object", "CryptoObject", "RGBA", ids, kNone, false},
    AovInfo{Aov::crypto_material, "crypto_material", "CryptoMaterial", "RGBA", ids, kNone, false},
    AovInfo{Aov::crypto_asset, "crypto_asset", "CryptoAsset", "RGBA", ids, kNone, false},
    AovInfo{Aov::samples, "samples", "samples", "Y", own, kNone, false},
    AovInfo{Aov::variance, "variance", "variance", "RGB", own, kPlaneReplicates, false},
};

constexpr bool in_order() {
    for (std::size_t i = 0; i < kAovs.size(); ++i)
        if (std::size_t(kAovs[i].aov) != i) return false;
    return true;
}
static_assert(in_order());

std::string known_names() {
    std::string names;
    for (const AovInfo& info : kAovs)
        names += std::string(info.name) + ", ";
    return names + "all";
}

}  // namespace

std::span<const AovInfo> all_aovs() {
    return kAovs;
}

const AovInfo& aov_info(Aov aov) {
    return kAovs[std::size_t(aov)];
}

bool AovSelection::has(Aov aov) const {
    return std::find(aovs.begin(), aovs.end(), aov) != aovs.end();
}

bool AovSelection::wants_ids() const {
    return std::any_of(aovs.begin(), aovs.end(),
                       [](Aov aov) { return aov_info(aov).value == AovValue::ids; });
}

bool AovSelection::needs_planes() const {
    return std::any_of(aovs.begin(), aovs.end(), [](Aov aov) { return aov != Aov::samples; });
}

tl::expected<std::vector<Aov>, std::string> parse_aovs(std::string_view text) {
    std::array<bool, kAovs.size()> chosen{};
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const std::string_view name = text.substr(at, end - at);
        at = end + 1;
        bool known = name == "all";
        for (std::size_t i = 0; i < kAovs.size(); ++i) {
            if (name == "all" ? kAovs[i].aov == Aov::variance : name != kAovs[i].name) continue;
            chosen[i] = known = true;
        }
        if (!known)
            return tl::unexpected(fmt::format("\"{}\" is not one of {}", name, known_names()));
    }
    std::vector<Aov> aovs;
    for (std::size_t i = 0; i < kAovs.size(); ++i)
        if (chosen[i]) aovs.push_back(kAovs[i].aov);
    return aovs;
}

std::string aov_names(std::span<const Aov> aovs) {
    std::string text;
    for (const Aov aov : aovs)
        text += fmt::format("{}{}", text.empty() ? "" : ",", aov_info(aov).name);
    return text;
}

}  // namespace hm
