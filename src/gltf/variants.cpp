#include "gltf/variants.h"

#include <fmt/format.h>

#include <set>

#include "base/text.h"

namespace hm::gltf {
namespace {

constexpr std::string_view kExtension = "KHR_materials_variants";

}  // namespace

Result<void> choose_variant(const Json& root, Source& source) {
    std::vector<Json> variants;
    HM_TRY_ASSIGN(const auto extension, extension_of(root, kExtension));
    if (extension) {
        if (!extension->has("variants")) return extension->invalid("variants", "is required");
        HM_TRY_ASSIGN(variants, extension->objects("variants"));
    }
    source.variant_count = variants.size();
    const std::string& wanted = source.options.variant;
    std::string known;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        HM_TRY_ASSIGN(const std::string_view name,
                      variants[i].required("name", variants[i].text("name")));
        if (name == wanted && !source.variant && !wanted.empty()) source.variant = i;
        known += (i == 0 ? "" : ", ") + excerpt(name);
    }
    if (wanted.empty() || source.variant) return {};
    return fail_setting("variant",
                        fmt::format("there is no variant {}; the file has {}", excerpt(wanted),
                                    known.empty() ? "none" : known),
                        source.file);
}

Result<std::optional<std::size_t>> read_material_index(const Json& primitive, const Source& source,
                                                       std::size_t material_count) {
    HM_TRY_ASSIGN(auto material, primitive.index("material", material_count, "materials"));
    HM_TRY_ASSIGN(const auto extension, extension_of(primitive, kExtension));
    if (!extension) return material;
    if (!extension->has("mappings")) return extension->invalid("mappings", "is required");
    HM_TRY_ASSIGN(const std::vector<Json> mappings, extension->objects("mappings"));
    std::set<std::size_t> mapped;
    for (const Json& mapping : mappings) {
        HM_TRY_ASSIGN(
            const std::size_t other,
            mapping.required("material", mapping.index("material", material_count, "materials")));
        if (!mapping.has("variants")) return mapping.invalid("variants", "is required");
        HM_TRY_ASSIGN(const auto variants,
                      mapping.indices("variants", source.variant_count, "variants"));
        for (const std::size_t variant : variants) {
            if (!mapped.insert(variant).second)
                return mapping.invalid("variants", fmt::format("variant {} is repeated", variant));
            if (variant == source.variant) material = other;
        }
    }
    return material;
}

}  // namespace hm::gltf
