#include "gltf/variants.h"

#include <fmt/format.h>

#include <algorithm>

namespace hm::gltf {
namespace {

constexpr std::string_view kExtension = "KHR_materials_variants";

}  // namespace

Result<void> choose_variant(const Json& root, Source& source) {
    std::vector<Json> variants;
    HM_TRY_ASSIGN(const auto extension, root.extension(kExtension));
    if (extension) {
        HM_TRY_ASSIGN(variants, extension->objects("variants"));
    }
    source.variant_count = variants.size();
    const std::string& wanted = source.options.variant;
    std::string known;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        HM_TRY_ASSIGN(const std::string name, variants[i].name());
        if (name == wanted && !source.variant && !wanted.empty()) source.variant = i;
        known += (i == 0 ? "" : ", ") + excerpt(name);
    }
    if (wanted.empty() || source.variant) return {};
    return root.fail(ExitCode::usage, "",
                     fmt::format("--variant: there is no variant {}; the file has {}",
                                 excerpt(wanted), known.empty() ? "none" : known));
}

Result<std::optional<std::size_t>> read_material_index(const Json& primitive, const Source& source,
                                                       std::size_t material_count) {
    HM_TRY_ASSIGN(auto material, primitive.index("material", material_count, "materials"));
    HM_TRY_ASSIGN(const auto extension, primitive.extension(kExtension));
    if (!extension) return material;
    HM_TRY_ASSIGN(const std::vector<Json> mappings, extension->objects("mappings"));
    for (const Json& mapping : mappings) {
        HM_TRY_ASSIGN(
            const std::size_t other,
            mapping.required("material", mapping.index("material", material_count, "materials")));
        HM_TRY_ASSIGN(const auto variants,
                      mapping.indices("variants", source.variant_count, "variants"));
        if (source.variant &&
            std::find(variants.begin(), variants.end(), *source.variant) != variants.end())
            material = other;
    }
    return material;
}

}  // namespace hm::gltf
