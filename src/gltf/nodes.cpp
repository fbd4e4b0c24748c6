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

// Parents and children of the file's nodes.
struct Hierarchy {
    std::vector<int> parents;  // kUnset for roots
    std::vector<int> children;
    std::vector<std::uint32_t> child_ends{0};  // node i's children are in [i] to [i + 1]

    std::size_t size() const { return parents.size(); }
    std::span<const int> children_of(std::size_t node) const {
        return std::span(children).subspan(child_ends[node],
                                           child_ends[node + 1] - child_ends[node]);
    }
};

int to_int(const std::optional<std::size_t>& index) {
    return index ? static_cast<int>(*index) : kUnset;
}

tl::unexpected<Error> invalid_node(const Source& source, int node, std::string message) {
    return fail(ErrorKind::invalid, source.file, fmt::format("/nodes/{}", node),
                std::move(message));
}

// KHR_node_visibility of the node itself, regardless of its ancestors.
Result<bool> read_visible(const Json& item) {
    HM_TRY_ASSIGN(const auto& extension, extension_of(item, "KHR_node_visibility"));
    if (!extension || !extension->has("visible")) return true;
    return extension->flag("visible");
}

Result<void> read_extensions(const Json& item, Source& source, const Scene& scene, Node& out) {
    HM_TRY_ASSIGN(out.visible, read_visible(item));
    HM_TRY_ASSIGN(out.instances, read_instances(item, source));
    if (!out.instances.empty() && (out.mesh == kUnset || out.skin != kUnset)) {
        source.warn(item.pointer(), "instances of a skinned mesh or of no mesh are not rendered");
        out.instances.clear();
    }
    HM_TRY_ASSIGN(const auto& lights, extension_of(item, "KHR_lights_punctual"));
    if (!lights) return {};
    HM_TRY_ASSIGN(const std::size_t light,
                  lights->required("light", lights->index("light", scene.lights.size(), "lights")));
    out.light = static_cast<int>(light);
    return {};
}

// Everything but parents and children.
Result<void> read_node(const Json& item, Source& source, std::size_t skin_count, const Scene& scene,
                       Node& out) {
    HM_TRY_ASSIGN(out.name, name_of(item));
    HM_TRY(read_transform(item, out));
    HM_TRY_ASSIGN(const auto& mesh, item.index("mesh", scene.meshes.size(), "meshes"));
    HM_TRY_ASSIGN(const auto& skin, item.index("skin", skin_count, "skins"));
    if (skin && !mesh) return item.invalid("skin", "a node with a skin must have a mesh");
    HM_TRY_ASSIGN(out.weights, read_weights(item, mesh ? scene.meshes[*mesh].weights.size() : 0));
    HM_TRY_ASSIGN(const auto& camera, item.index("camera", scene.cameras.size(), "cameras"));
    out.mesh = to_int(mesh);
    out.skin = to_int(skin);
    out.camera = to_int(camera);
    if (!item.has("extensions")) return {};
    return read_extensions(item, source, scene, out);
}

// Fails unless the nodes form strict trees (3.5.2).
Result<void> set_parents(const Source& source, Hierarchy& nodes) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes.children_of(i)) {
            int& parent = nodes.parents[std::size_t(child)];
            if (parent != kUnset)
                return invalid_node(source, child,
                                    fmt::format("is a child of node {} and of node {}", parent, i));
            parent = static_cast<int>(i);
        }
    }
    // Each node has one parent, so a node visited twice on a walk to the root is part of a cycle.
    // Walks stop at nodes visited by earlier ones, so this takes linear time.
    std::vector<std::size_t> walk_of(nodes.size(), 0);  // 0: not visited
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        std::size_t at = i;
        while (walk_of[at] == 0) {
            walk_of[at] = i + 1;
            const int parent = nodes.parents[at];
            if (parent == kUnset) break;
            at = static_cast<std::size_t>(parent);
            if (walk_of[at] == i + 1) return invalid_node(source, parent, "is its own ancestor");
        }
    }
    return {};
}

// Reads all nodes into scene.nodes, in file order.
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

// The scene with the name or index in the options; names first.
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

// The root nodes of the scene chosen by the options or by "scene", else of the first scene, else of
// the whole file.
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
        source.warn("", "the file has no scene; all nodes are rendered");
        return all_roots(nodes);
    }
    const Json& scene = scenes[chosen];
    HM_TRY_ASSIGN(std::vector<std::size_t> roots, scene.indices("nodes", nodes.size(), "nodes"));
    std::vector<bool> listed(nodes.size(), false);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const auto key = [&] { return fmt::format("nodes/{}", i); };
        if (listed[roots[i]])
            return scene.invalid(key(), fmt::format("node {} is repeated", roots[i]));
        if (nodes.parents[roots[i]] != kUnset)
            return scene.invalid(key(), fmt::format("node {} is a child of node {}", roots[i],
                                                    nodes.parents[roots[i]]));
        listed[roots[i]] = true;
    }
    if (roots.empty()) source.warn(scene.pointer(), "the scene is empty");
    return roots;
}

// Maps the file's node indices to the scene's, or to kUnset. Depth first, so that parents come
// before children and siblings keep their order.
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

// Moves each node to its index in `scene_node` and drops the others. In place, since there may be
// millions.
void reorder(std::vector<Node>& nodes, std::vector<int> scene_node) {
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

// Whether the node's world transforms fit 32-bit floats.
bool all_finite(const Node& node, const glm::dmat4& world) {
    return is_finite(glm::mat4(world)) &&
           std::all_of(node.instances.begin(), node.instances.end(),
                       [&](const glm::mat4& instance) {
                           return is_finite(glm::mat4(world * glm::dmat4(instance)));
                       });
}

// Fails if a world transform overflows.
Result<void> check_finite(const Source& source, const Scene& scene) {
    struct Ancestor {
        int node;
        glm::dmat4 world;
    };
    std::vector<Ancestor> path;  // nodes are in depth-first order, so this is enough
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        while (!path.empty() && path.back().node != node.parent)
            path.pop_back();
        const glm::dmat4 world = path.empty() ? node.local : path.back().world * node.local;
        if (!all_finite(node, world))
            return invalid_node(source, node.index, "its world transform overflows a 32-bit float");
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
    reorder(scene.nodes, scene_node);
    HM_TRY(check_finite(source, scene));
    return scene_node;
}

}  // namespace hm::gltf
