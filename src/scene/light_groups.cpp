#include "scene/light_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shading/math.h"

namespace hm {
namespace {

// Dots would nest layers, blanks and others break what people type.
std::string layer_word(const std::string& name) {
    std::string word;
    for (const char c : name)
        word += (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                        c == '-' || (c & 0x80) != 0
                    ? c
                    : '_';
    return word;
}

std::uint32_t add_group(LightGroups& groups, const std::string& wanted, const char* kind,
                        std::size_t number) {
    const std::string word =
        wanted.empty() ? fmt::format("{}_{}", kind, number) : layer_word(wanted);
    std::string name = word;
    for (int n = 2; std::find(groups.names.begin(), groups.names.end(), name) != groups.names.end();
         ++n)
        name = fmt::format("{}_{}", word, n);
    groups.names.push_back(name);
    return std::uint32_t(groups.names.size()) - 1;
}

}  // namespace

LightGroups find_light_groups(const Scene& scene, const FlatScene& flat) {
    LightGroups groups{{"environment"}, {0}};
    std::map<int, std::uint32_t> of_light;
    for (const std::uint32_t node : flat.light_nodes) {
        const int light = scene.nodes[node].light;
        if (!of_light.contains(light)) {
            const std::string& name = scene.lights[std::size_t(light)].name;
            of_light[light] = add_group(groups, name.empty() ? scene.nodes[node].name : name,
                                        "light", std::size_t(light));
        }
        groups.source_groups.push_back(of_light[light]);
    }
    for (std::size_t m = 0; m < flat.materials.size(); ++m) {
        const MaterialData& material = flat.materials[m];
        const bool emits =
            max_component(material.emissive_factor) > 0 || (material.flags & kMaterialUnlit) != 0;
        const bool named = m < scene.materials.size();
        groups.source_groups.push_back(
            emits ? add_group(groups, named ? scene.materials[m].name : "", "material", m) : 0);
    }
    return groups;
}

}  // namespace hm
