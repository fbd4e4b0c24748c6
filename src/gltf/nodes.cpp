#include "gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gltf/budget.h"
#include "gltf/mesh_instancing.h"
#include "gltf/morph.h"
#include "gltf/transform.h"

namespace hm::gltf {
namespace {

struct FileNode {
    Node node;  // `parent` is an index of the file's nodes
    std::vector<std::size_t> children;
};

int to_int(const std::optional<std::size_t>& index) {
    return index ? static_cast<int>(*index) : kUnset;
}

tl::unexpected<Error> broken(const Source& source, std::size_t node, std::string message) {
    return fail(ExitCode::invalid, source.file, fmt::format("/nodes/{}", node), std::move(message));
}

struct Counts {
    std::size_t nodes, skins;
};

// KHR_node_visibility; whether the node's ancestors are visible is another matter.
Result<bool> read_visible(const Json& item) {
    HM_TRY_ASSIGN(const auto extension, item.extension("KHR_node_visibility"));
    if (!extension || !extension->has("visible")) return true;
    return extension->flag("visible");
}

Result<void> read_node(const Json& item, Source& source, const Counts& counts, const Scene& scene,
                       FileNode& out) {
    HM_TRY_ASSIGN(out.node.name, item.name());
    HM_TRY(read_transform(item, out.node));
    HM_TRY_ASSIGN(const auto mesh, item.index("mesh", scene.meshes.size(), "meshes"));
    HM_TRY_ASSIGN(const auto skin, item.index("skin", counts.skins, "skins"));
    if (skin && !mesh) return item.invalid("skin", "a node without a mesh has no skin");
    HM_TRY_ASSIGN(out.node.weights,
                  read_weights(item, mesh ? scene.meshes[*mesh].weights.size() : 0));
    HM_TRY_ASSIGN(const auto camera, item.index("camera", scene.cameras.size(), "cameras"));
    HM_TRY_ASSIGN(out.children, item.indices("children", counts.nodes, "nodes"));
    out.node.mesh = to_int(mesh);
    out.node.skin = to_int(skin);
    out.node.camera = to_int(camera);
    HM_TRY_ASSIGN(out.node.visible, read_visible(item));
    HM_TRY_ASSIGN(out.node.instances, read_instances(item, source));
    if (!out.node.instances.empty() && (!mesh || skin)) {
        source.warn(item.place(), "instances of no mesh or of a skinned one are not drawn");
        out.node.instances.clear();
    }
    HM_TRY_ASSIGN(const auto lights, item.extension("KHR_lights_punctual"));
    if (lights) {
        HM_TRY_ASSIGN(
            const std::size_t light,
            lights->required("light", lights->index("light", scene.lights.size(), "lights")));
        out.node.light = static_cast<int>(light);
    }
    return {};
}

// Sets the parents. Fails unless the nodes are strict trees (3.5.2).
Result<void> link_parents(const Source& source, std::vector<FileNode>& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const std::size_t child : nodes[i].children) {
            int& parent = nodes[child].node.parent;
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
            const int parent = nodes[at].node.parent;
            if (parent == kUnset) break;
            at = static_cast<std::size_t>(parent);
            if (walk_of[at] == i + 1) return broken(source, at, "is its own ancestor");
        }
    }
    return {};
}

std::vector<std::size_t> all_roots(const std::vector<FileNode>& nodes) {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].node.parent == kUnset) roots.push_back(i);
    return roots;
}

// The scene of the options' name or index, a name first.
Result<std::size_t> find_scene(const Json& root, const std::vector<Json>& scenes,
                               const std::string& wanted) {
    std::string known;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        HM_TRY_ASSIGN(const std::string name, scenes[i].name());
        if (name == wanted) return i;
        known += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, excerpt(name));
    }
    std::size_t index = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto [stopped, error] = std::from_chars(wanted.data(), end, index);
    if (error == std::errc() && stopped == end && index < scenes.size()) return index;
    return root.fail(ExitCode::usage, "",
                     fmt::format("--scene: there is no scene {}; the file has {}", excerpt(wanted),
                                 known.empty() ? "none" : known));
}

// The root nodes of the scene that the options or "scene" name, of the first one, or of the whole
// file.
Result<std::vector<std::size_t>> choose_roots(const Json& root, Source& source,
                                              const std::vector<FileNode>& nodes) {
    HM_TRY_ASSIGN(const std::vector<Json> scenes, root.objects("scenes"));
    for (const Json& scene : scenes)
        HM_TRY(scene.name());
    HM_TRY_ASSIGN(const auto named, root.index("scene", scenes.size(), "scenes"));
    std::size_t chosen = named.value_or(0);
    if (!source.options.scene.empty()) {
        HM_TRY_ASSIGN(chosen, find_scene(root, scenes, source.options.scene));
    }
    if (scenes.empty()) {
        source.warn("", "the file has no scene; all its nodes are shown");
        return all_roots(nodes);
    }
    const Json& scene = scenes[chosen];
    HM_TRY_ASSIGN(std::vector<std::size_t> roots, scene.indices("nodes", nodes.size(), "nodes"));
    std::vector<bool> listed(nodes.size(), false);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const std::string key = fmt::format("nodes/{}", i);
        if (listed[roots[i]]) return scene.invalid(key, fmt::format("node {} again", roots[i]));
        if (nodes[roots[i]].node.parent != kUnset)
            return scene.invalid(key, fmt::format("node {} is a child of node {}", roots[i],
                                                  nodes[roots[i]].node.parent));
        listed[roots[i]] = true;
    }
    if (roots.empty()) source.warn(scene.place(), "the scene is empty");
    return roots;
}

// Depth first, so that parents come before children and siblings keep their order. Returns the new
// index of each node, or kUnset.
std::vector<int> flatten(std::vector<FileNode>& nodes, const std::vector<std::size_t>& roots,
                         Scene& scene) {
    std::vector<int> new_index(nodes.size(), kUnset);
    std::vector<std::size_t> open(roots.rbegin(), roots.rend());
    scene.nodes.reserve(nodes.size());
    while (!open.empty()) {
        const std::size_t at = open.back();
        open.pop_back();
        FileNode& file_node = nodes[at];
        const int parent = file_node.node.parent;
        if (parent != kUnset) file_node.node.parent = new_index[std::size_t(parent)];
        new_index[at] = static_cast<int>(scene.nodes.size());
        scene.nodes.push_back(std::move(file_node.node));
        open.insert(open.end(), file_node.children.rbegin(), file_node.children.rend());
    }
    return new_index;
}

bool is_finite(const glm::mat4& m) {
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r])) return false;
    return true;
}

bool all_finite(const Node& node, const glm::mat4& world) {
    return is_finite(world) &&
           std::all_of(node.instances.begin(), node.instances.end(),
                       [&](const glm::mat4& instance) { return is_finite(world * instance); });
}

}  // namespace

Result<std::vector<int>> read_nodes(const Json& root, Source& source, Scene& scene) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("nodes"));
    HM_TRY_ASSIGN(const std::vector<Json> skins, root.objects("skins"));
    HM_TRY(take_memory(root, source, items.size() * (sizeof(FileNode) + sizeof(Node))));
    std::vector<FileNode> nodes;
    nodes.reserve(items.size());
    for (const Json& item : items) {
        FileNode& out = nodes.emplace_back();
        out.node.index = static_cast<int>(nodes.size()) - 1;
        HM_TRY(read_node(item, source, {items.size(), skins.size()}, scene, out));
    }
    HM_TRY(link_parents(source, nodes));
    HM_TRY_ASSIGN(const auto roots, choose_roots(root, source, nodes));
    std::vector<int> scene_node = flatten(nodes, roots, scene);
    const std::vector<glm::mat4> world = world_transforms(scene);
    for (std::size_t i = 0; i < scene_node.size(); ++i)
        if (scene_node[i] != kUnset &&
            !all_finite(scene.nodes[std::size_t(scene_node[i])], world[std::size_t(scene_node[i])]))
            return broken(source, i, "its world transform overflows a 32-bit float");
    return scene_node;
}

}  // namespace hm::gltf
