#include "scene/light_groups.h"

#include <fmt/format.h>

#include <unordered_map>
#include <unordered_set>

#include "shading/math.h"

namespace hm {
namespace {

// A dot would nest layers; spaces and special characters are hard to type and quote.
std::string layer_word(const std::string& name) {
    std::string word;
    for (const char c : name)
        word += (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                        c == '-' || (c & 0x80) != 0
                    ? c
                    : '_';
    return word;
}

// Makes names unique by appending numbers: "lamp", "lamp_2", "lamp_3", ... Names are never removed,
// so the search for the next free suffix of a word continues where its last search ended.
class GroupNames {
  public:
    explicit GroupNames(std::vector<std::string>& names)
        : names_(names), taken_(names.begin(), names.end()) {}

    std::uint32_t add(const std::string& wanted, const char* kind, std::size_t number) {
        const std::string word =
            wanted.empty() ? fmt::format("{}_{}", kind, number) : layer_word(wanted);
        std::string name = word;
        if (taken_.contains(name)) {
            std::uint32_t& next = next_.try_emplace(word, 2).first->second;
            do {
                name = fmt::format("{}_{}", word, next++);
            } while (taken_.contains(name));
        }
        taken_.insert(name);
        names_.push_back(std::move(name));
        return std::uint32_t(names_.size()) - 1;
    }

  private:
    std::vector<std::string>& names_;
    std::unordered_set<std::string> taken_;
    std::unordered_map<std::string, std::uint32_t> next_;
};

}  // namespace

LightGroups find_light_groups(const Scene& scene, const FlatScene& flat) {
    LightGroups groups{{"environment"}, {0}};
    GroupNames names(groups.names);
    std::unordered_map<int, std::uint32_t> of_light;
    for (const std::uint32_t node : flat.light_nodes) {
        const int light = scene.nodes[node].light;
        if (!of_light.contains(light)) {
            const std::string& name = scene.lights[std::size_t(light)].name;
            of_light[light] = names.add(name.empty() ? scene.nodes[node].name : name, "light",
                                        std::size_t(light));
        }
        groups.source_groups.push_back(of_light[light]);
    }
    for (std::size_t m = 0; m < flat.materials.size(); ++m) {
        const MaterialData& material = flat.materials[m];
        const bool emits =
            max_component(material.emissive_factor) > 0 || (material.flags & kMaterialUnlit) != 0;
        const bool named = m < scene.materials.size();
        groups.source_groups.push_back(
            emits ? names.add(named ? scene.materials[m].name : "", "material", m) : 0);
    }
    return groups;
}

}  // namespace hm
