#include "gltf/animation_pointer.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "base/text.h"
#include "scene/material_parameters.h"

namespace hm::gltf {
namespace {

// "#" is the owner's index. The glTF 2.0 Asset Object Model lists all valid pointers. Materials
// have their own list (scene/material_parameters.h); channels with pointers that are in neither
// (texture transforms, single weights, a mesh's weights) are ignored with a warning.
struct Property {
    std::string_view pointer;
    Pointed what;
};
constexpr std::string_view kLights = "/extensions/KHR_lights_punctual/lights";
constexpr Property kProperties[] = {
    {"/nodes/#/translation", AnimatedProperty::translation},
    {"/nodes/#/rotation", AnimatedProperty::rotation},
    {"/nodes/#/scale", AnimatedProperty::scale},
    {"/nodes/#/weights", AnimatedProperty::weights},
    {"/nodes/#/extensions/KHR_node_visibility/visible", AnimatedValue::node_visible},
#define HM_ANIMATED(value, pointer, table, member, low, high) {pointer, AnimatedValue::value},
#include "scene/animated_values.inl"
    {"/cameras/#/perspective/aspectRatio", {}},
    {"/cameras/#/perspective/znear", {}},
    {"/cameras/#/perspective/zfar", {}},
    {"/cameras/#/orthographic/zfar", {}},
};

// "/materials/3/normalTexture/scale" is split into "/materials", 3, "/normalTexture/scale".
struct Parts {
    std::string_view table;
    std::size_t owner = 0;
    std::string_view rest;
};

std::optional<Parts> split(std::string_view pointer) {
    const std::size_t slash =
        pointer.starts_with(kLights) ? pointer.find('/', kLights.size()) : pointer.find('/', 1);
    if (slash == pointer.npos) return std::nullopt;
    const char* const first = pointer.data() + slash + 1;
    const char* const end = pointer.data() + pointer.size();
    Parts out;
    const auto [stopped, error] = std::from_chars(first, end, out.owner);
    // Array indices have no leading zeros (RFC 6901).
    if (error != std::errc() || stopped == end || (*first == '0' && stopped - first > 1))
        return std::nullopt;
    out.table = pointer.substr(0, slash);
    out.rest = std::string_view(stopped, std::size_t(end - stopped));
    return out;
}

std::optional<Pointed> find_material_property(std::string_view rest) {
    for (const MaterialFactor& factor : material_factors())
        if (pointer_in_material(factor.owner, factor.key) == rest)
            return factor.animated ? Pointed(factor.value) : Pointed();
    return std::nullopt;
}

std::optional<Pointed> find_property(const Parts& parts) {
    if (parts.table == "/materials") return find_material_property(parts.rest);
    const std::string pattern = fmt::format("{}/#{}", parts.table, parts.rest);
    for (const Property& property : kProperties)
        if (property.pointer == pattern) return property.what;
    return std::nullopt;
}

}  // namespace

// The tables are cached: a file may have as many channels as owners, and searching the array for
// each would be quadratic.
Result<bool> PointerReader::target_exists(std::string_view table, std::size_t owner,
                                          std::string_view rest) {
    auto known = tables_.find(table);
    if (known == tables_.end()) {
        std::vector<Json> items;
        if (table == kLights) {
            HM_TRY_ASSIGN(const auto extension, extension_of(root_, "KHR_lights_punctual"));
            if (extension) {
                HM_TRY_ASSIGN(items, extension->objects("lights"));
            }
        } else {
            HM_TRY_ASSIGN(items, root_.objects(table.substr(1)));
        }
        known = tables_.emplace(table, std::move(items)).first;
    }
    // The property may be absent (its default applies), but the object that holds it must exist.
    if (owner >= known->second.size()) return false;
    const auto found = known->second[owner].at(rest.substr(0, rest.rfind('/')));
    return found && found->type() == JsonType::object;
}

Result<std::optional<PointedProperty>> PointerReader::read(const Json& target) {
    HM_TRY_ASSIGN(const auto extension, extension_of(target, "KHR_animation_pointer"));
    if (!extension) return std::nullopt;
    HM_TRY_ASSIGN(const std::string_view pointer,
                  extension->required("pointer", extension->text("pointer")));
    const auto parts = split(pointer);
    if (!parts) return std::nullopt;
    const auto known = find_property(*parts);
    if (!known) return std::nullopt;
    HM_TRY_ASSIGN(const bool found, target_exists(parts->table, parts->owner, parts->rest));
    if (!found) return std::nullopt;
    return PointedProperty{*known, parts->owner};
}

}  // namespace hm::gltf
