#include "gltf/asset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "base/text.h"
#include "gltf/specular_glossiness.h"
#include "scene/material_parameters.h"

namespace hm::gltf {
namespace {

constexpr std::string_view kQuantization = "KHR_mesh_quantization";
// In addition to those in the list of material parameters.
constexpr std::array<std::string_view, 9> kSupported{
    "EXT_mesh_gpu_instancing", "KHR_animation_pointer",  "KHR_lights_punctual",
    "KHR_materials_unlit",     "KHR_materials_variants", kQuantization,
    "KHR_node_visibility",     "KHR_texture_transform",  kSpecularGlossiness};

// Metadata that does not affect the picture.
constexpr std::array<std::string_view, 8> kMetadata{"EXT_structural_metadata",
                                                    "EXT_mesh_features",
                                                    "EXT_instance_features",
                                                    "FB_ngon_encoding",
                                                    "KHR_xmp_json_ld",
                                                    "KHR_xmp",
                                                    "VRM",
                                                    "VRMC_vrm"};

bool is_metadata(std::string_view extension) {
    return std::find(kMetadata.begin(), kMetadata.end(), extension) != kMetadata.end();
}

// A glTF Transform command (gltf-transform.dev) that converts the file to one without the
// extension.
std::string_view remedy(std::string_view extension) {
    if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression" ||
        extension == "KHR_meshopt_compression")
        return "gltf-transform copy IN OUT";
    if (extension == "EXT_texture_webp" || extension == "EXT_texture_avif" ||
        extension == "KHR_texture_basisu")
        return kPicturesToPng;
    return {};
}

struct Version {
    unsigned major = 0;
    unsigned minor = 0;
};

// "2.0": two numbers separated by a dot.
std::optional<Version> parse_version(std::string_view text) {
    Version version;
    const char* const end = text.data() + text.size();
    const auto major = std::from_chars(text.data(), end, version.major);
    if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    if (minor.ec != std::errc() || minor.ptr != end) return std::nullopt;
    return version;
}

Result<std::optional<Version>> read_version(const Json& asset, std::string_view key) {
    HM_TRY_ASSIGN(const auto text, asset.text(key));
    if (!text) return std::nullopt;
    const auto version = parse_version(*text);
    if (!version) return asset.invalid(key, fmt::format("{} is not a version", excerpt(*text)));
    return version;
}

// One warning per extension, with the number of objects that use it.
void warn_of_ignored(const KeyCounts& uses, const std::vector<std::string_view>& used,
                     Source& source) {
    std::set<std::string_view> listed;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!listed.insert(used[i]).second || is_supported(used[i])) continue;
        const auto found = uses.find(used[i]);
        const std::string pointer = fmt::format("/extensionsUsed/{}", i);
        const std::string name = excerpt(used[i]);
        if (found == uses.end())
            source.note(pointer, fmt::format("extension {} is listed but not used", name));
        else if (is_metadata(used[i]))
            source.note(pointer, fmt::format("extension {} is metadata and ignored", name),
                        found->second);
        else
            source.warn(pointer, fmt::format("extension {} is not supported and ignored", name),
                        found->second);
    }
    for (const auto& [name, count] : uses)
        if (!is_supported(name) && !is_metadata(name) && !listed.contains(name))
            source.warn(
                "/extensionsUsed",
                fmt::format("unlisted extension {} is not supported and ignored", excerpt(name)),
                count);
}

}  // namespace

bool is_supported(std::string_view extension) {
    return has_material_parameters(extension) ||
           std::find(kSupported.begin(), kSupported.end(), extension) != kSupported.end();
}

Result<void> check_asset(const Json& root) {
    HM_TRY_ASSIGN(const Json asset, root.required("asset", root.object("asset")));
    HM_TRY_ASSIGN(const Version version, asset.required("version", read_version(asset, "version")));
    HM_TRY(asset.text("generator"));
    HM_TRY(asset.text("copyright"));
    if (version.major != 2)
        return asset.fail(
            ErrorKind::unsupported, "version",
            fmt::format("glTF {}.{} is not supported, only 2.x", version.major, version.minor));
    HM_TRY_ASSIGN(const auto least, read_version(asset, "minVersion"));
    if (least && (least->major != 2 || least->minor > 0))
        return asset.fail(ErrorKind::unsupported, "minVersion",
                          fmt::format("the file requires glTF {}.{}; this program supports 2.0",
                                      least->major, least->minor));
    return {};
}

Result<std::string> generator_of(const Json& root) {
    HM_TRY_ASSIGN(const Json asset, root.required("asset", root.object("asset")));
    HM_TRY_ASSIGN(const auto text, asset.text("generator"));
    return std::string(text.value_or(""));
}

Result<void> check_extensions(const JsonDocument& document, Source& source) {
    const Json& root = document.root();
    HM_TRY_ASSIGN(const auto required, root.texts("extensionsRequired"));
    std::string missing;
    for (const std::string_view name : required) {
        if (is_supported(name) || is_metadata(name)) continue;
        if (!missing.empty()) missing += ", ";
        missing += name;
        if (!remedy(name).empty()) missing += fmt::format(" (convert with: {})", remedy(name));
    }
    if (!missing.empty())
        return root.fail(ErrorKind::unsupported, "extensionsRequired",
                         fmt::format("required but not supported: {}", missing));

    HM_TRY_ASSIGN(const auto used, root.texts("extensionsUsed"));
    warn_of_ignored(document.key_counts(), used, source);
    // Some exporters do not list it as required.
    source.quantized = std::count(used.begin(), used.end(), kQuantization) > 0 ||
                       std::count(required.begin(), required.end(), kQuantization) > 0;
    return {};
}

}  // namespace hm::gltf
