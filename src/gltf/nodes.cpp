#include "gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

#include "base/text.h"
#include "gltf/budget.h"
#include "gltf/mesh_instancing.h"
#include "gltf/morph.h"
#include "gltf/transform.h"

namespace hm::gltf {
namespace {

// How the file's nodes hang together.
struct Hierarchy {
    std::vector<int> parents;  // kUnset for roots
    std::vector<int> children;
    std::vector<std::uint32_t> child_ends{0};  // node i's children end at [i + 1], and begin at [i]

    std::size_t size() const { return parents.size(); }
    std::span<const int> children_of(std::size_t node) const {
        return std::span(children).subspan(child_ends[node],
                                           child_ends[node + 1] - child_ends[node]);
    }
};

int to_int(const std::optional<std::size_t>& index) {
    return index ? static_cast<int>(*index) : kUnset;
}

tl::unexpected<Error> broken(const Source& source, int node, std::string message) {
    return fail(ErrorKind::invalid, source.file, fmt::format("/nodes/{}", node),
                std::move(message));
}

// KHR_node_visibility; whether the node's ancestors are visible is another matter.
Result<bool> read_visible(const Json& item) {
    HM_TRY_ASSIGN(const auto& extension, extension_of(item, "KHR_node_visibility"));
    if (!extension || !extension->has("visible")) return true;
    return extension->flag("visible");
}

Result<void> read_extensions(const Json& item, Source& source, const Scene& scene, Node& out) {
    HM_TRY_ASSIGN(out.visible, read_visible(item));
    HM_TRY_ASSIGN(out.instances, read_instances(item, source));
    if (!out.instances.empty() && (out.mesh == kUnset || out.skin != kUnset)) {
        source.warn(item.pointer(), "instances of no mesh or of a skinned one are not drawn");
        out.instances.clear();
    }
    HM_TRY_ASSIGN(const auto& lights, extension_of(item, "KHR_lights_punctual"));
    if (!lights) return {};
    HM_TRY_ASSIGN(const std::size_t light,
                  lights->required("light", lights->index("light", scene.lights.size(), "lights")));
    out.light = static_cast<int>(light);
    return {};
}

// All but its place in the hierarchy.
Result<void> read_node(const Json& item, Source& source, std::size_t skin_count, const Scene& scene,
                       Node& out) {
    HM_TRY_ASSIGN(out.name, name_of(item));
    HM_TRY(read_transform(item, out));
    HM_TRY_ASSIGN(const auto& mesh, item.index("mesh", scene.meshes.size(), "meshes"));
    HM_TRY_ASSIGN(const auto& skin, item.index("skin", skin_count, "skins"));
    if (skin && !mesh) return item.invalid("skin", "a node without a mesh has no skin");
    HM_TRY_ASSIGN(out.weights, read_weights(item, mesh ? scene.meshes[*mesh].weights.size() : 0));
    HM_TRY_ASSIGN(const auto& camera, item.index("camera", scene.cameras.size(), "cameras"));
    out.mesh = to_int(mesh);
    out.skin = to_int(skin);
    out.camera = to_int(camera);
    if (!item.has("extensions")) return {};
    return read_extensions(item, source, scene, out);
}

// Fails unless the nodes are strict trees (3.5.2).
Result<void> set_parents(const Source& source, Hierarchy& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes.children_of(i)) {
            int& parent = nodes.parents[std::size_t(child)];
            if (parent != kUnset)
                return broken(source, child,
                              fmt::format("is a child of node {} and of node {}", parent, i));
            parent = static_cast<int>(i);
        }
    }
    // With one parent each, what a walk up from a node meets twice is a cycle. Every node is
    // passed once: a walk ends where an earlier one was.
    std::vector<std::size_t> walk_of(nodes.size(), 0);  // 0: not met yet
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::size_t at = i;
        while (walk_of[at] == 0) {
            walk_of[at] = i + 1;
            const int parent = nodes.parents[at];
            if (parent == kUnset) break;
            at = static_cast<std::size_t>(parent);
            if (walk_of[at] == i + 1) return broken(source, parent, "is its own ancestor");
        }
    }
    return {};
}

// All of the file's nodes, into scene.nodes as they stand in the file.
Result<Hierarchy> read_all(const Json& root, Source& source, std::size_t count, Scene& scene) {
    HM_TRY_ASSIGN(const std::size_t skin_count, root.count("skins"));
    Hierarchy nodes;
    nodes.parents.resize(count, kUnset);
    nodes.child_ends.reserve(count + 1);
    scene.nodes.reserve(count);
    const auto read_one = [&](const Json& item) -> Result<void> {
        Node& node = scene.nodes.emplace_back();
        node.index = static_cast<int>(scene.nodes.size()) - 1;
        HM_TRY(read_node(item, source, skin_count, scene, node));
        HM_TRY_ASSIGN(const auto& children, item.indices("children", count, "nodes"));
        nodes.children.insert(nodes.children.end(), children.begin(), children.end());
        nodes.child_ends.push_back(static_cast<std::uint32_t>(nodes.children.size()));
        return {};
    };
    HM_TRY(root.for_each_object("nodes", read_one));
    HM_TRY(set_parents(source, nodes));
    return nodes;
}

std::vector<std::size_t> all_roots(const Hierarchy& nodes) {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes.parents[i] == kUnset) roots.push_back(i);
    return roots;
}

// The scene of the options' name or index, a name first.
Result<std::size_t> find_scene(const std::vector<Json>& scenes, const Source& source) {
    const std::string& wanted = source.options.scene;
    std::string known;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        HM_TRY_ASSIGN(const std::string name, name_of(scenes[i]));
        if (name == wanted) return i;
        known += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, excerpt(name));
    }
    std::size_t index = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto [stopped, error] = std::from_chars(wanted.data(), end, index);
    if (error == std::errc() && stopped == end && index < scenes.size()) return index;
    return fail_setting("scene",
                        fmt::format("there is no scene {}; the file has {}", excerpt(wanted),
                                    known.empty() ? "none" : known),
                        source.file);
}

// The root nodes of the scene that the options or "scene" name, of the first one, or of the whole
// file.
Result<std::vector<std::size_t>> choose_roots(const Json& root, Source& source,
                                              const Hierarchy& nodes) {
    HM_TRY_ASSIGN(const std::vector<Json> scenes, root.objects("scenes"));
    for (const Json& scene : scenes)
        HM_TRY(name_of(scene));
    HM_TRY_ASSIGN(const auto& named, root.index("scene", scenes.size(), "scenes"));
    std::size_t chosen = named.value_or(0);
    if (!source.options.scene.empty()) {
        HM_TRY_ASSIGN(chosen, find_scene(scenes, source));
    }
    if (scenes.empty()) {
        source.warn("", "the file has no scene; all its nodes are shown");
        return all_roots(nodes);
    }
    const Json& scene = scenes[chosen];
    HM_TRY_ASSIGN(std::vector<std::size_t> roots, scene.indices("nodes", nodes.size(), "nodes"));
    std::vector<bool> listed(nodes.size(), false);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const auto key = [&] { return fmt::format("nodes/{}", i); };
        if (listed[roots[i]]) return scene.invalid(key(), fmt::format("node {} again", roots[i]));
        if (nodes.parents[roots[i]] != kUnset)
            return scene.invalid(key(), fmt::format("node {} is a child of node {}", roots[i],
                                                    nodes.parents[roots[i]]));
        listed[roots[i]] = true;
    }
    if (roots.empty()) source.warn(scene.pointer(), "the scene is empty");
    return roots;
}

// The index that each of the file's nodes gets in the scene, or kUnset. Depth first, so that
// parents come before children and siblings keep their order.
std::vector<int> number_nodes(const Hierarchy& nodes, const std::vector<std::size_t>& roots) {
    std::vector<int> scene_node(nodes.size(), kUnset);
    std::vector<std::size_t> open(roots.rbegin(), roots.rend());
    for (int next = 0; !open.empty(); ++next) {
        const std::size_t at = open.back();
        open.pop_back();
        scene_node[at] = next;
        const auto children = nodes.children_of(at);
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return scene_node;
}

// Puts each node where `scene_node` says, and drops those that are not shown. In place: there may
// be millions.
void arrange(std::vector<Node>& nodes, std::vector<int> scene_node) {
    int next = static_cast<int>(
        nodes.size() - std::size_t(std::count(scene_node.begin(), scene_node.end(), kUnset)));
    const auto shown = static_cast<std::size_t>(next);
    for (int& at : scene_node)
        if (at == kUnset) at = next++;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        while (std::size_t(scene_node[i]) != i) {
            const auto to = static_cast<std::size_t>(scene_node[i]);
            std::swap(nodes[i], nodes[to]);
            std::swap(scene_node[i], scene_node[to]);
        }
    nodes.resize(shown);
}

bool is_finite(const glm::mat4& m) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

// Whether 32-bit floats can hold the node's world transforms.
bool all_finite(const Node& node, const glm::dmat4& world) {
    return is_finite(glm::mat4(world)) &&
           std::all_of(node.instances.begin(), node.instances.end(),
                       [&](const glm::mat4& instance) {
                           return is_finite(glm::mat4(world * glm::dmat4(instance)));
                       });
}

// That every node has a place in the world.
Result<void> check_finite(const Source& source, const Scene& scene) {
    struct Ancestor {
        int node;
        glm::dmat4 world;
    };
    std::vector<Ancestor> path;  // nodes stand depth first, so only these are still needed
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        while (!path.empty() && path.back().node != node.parent)
            path.pop_back();
        const glm::dmat4 world = path.empty() ? node.local : path.back().world * node.local;
        if (!all_finite(node, world))
            return broken(source, node.index, "its world transform overflows a 32-bit float");
        path.push_back({static_cast<int>(i), world});
    }
    return {};
}

}  // namespace

Result<std::vector<int>> read_nodes(const Json& root, Source& source, Scene& scene) {
    HM_TRY_ASSIGN(const std::size_t count, root.count("nodes"));
    constexpr std::size_t kLinks = 2 * sizeof(std::size_t) + 4 * sizeof(int);
    HM_TRY(take_memory(root, source, count * (sizeof(Node) + kLinks)));
    HM_TRY_ASSIGN(const Hierarchy hierarchy, read_all(root, source, count, scene));
    HM_TRY_ASSIGN(const auto& roots, choose_roots(root, source, hierarchy));
    std::vector<int> scene_node = number_nodes(hierarchy, roots);
    for (std::size_t i = 0; i < count; ++i)
        if (const int parent = hierarchy.parents[i]; parent != kUnset)
            scene.nodes[i].parent = scene_node[std::size_t(parent)];
    arrange(scene.nodes, scene_node);
    HM_TRY(check_finite(source, scene));
    return scene_node;
}

}  // namespace hm::gltf
