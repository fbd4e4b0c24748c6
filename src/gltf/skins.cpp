#include "gltf/skins.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "gltf/accessor.h"
#include "gltf/budget.h"
#include "gltf/transform.h"

namespace hm::gltf {
namespace {

Result<std::vector<glm::mat4>> read_inverse_bind(const Json& skin, Source& source,
                                                 std::size_t joint_count) {
    constexpr std::string_view kKey = "inverseBindMatrices";
    HM_TRY(take_memory(skin, source, joint_count * sizeof(glm::mat4)));
    std::vector<glm::mat4> out(joint_count, glm::mat4(1));
    HM_TRY_ASSIGN(const auto index, skin.index(kKey, source.accessors.size(), "accessors"));
    if (!index) return out;
    const Accessor& accessor = source.accessors[*index];
    if (accessor.type != ElementType::mat4 || accessor.component != ComponentType::float32)
        return skin.invalid(kKey, "inverse bind matrices must be MAT4 of floats");
    if (accessor.count < joint_count)
        return skin.invalid(kKey, fmt::format("accessor {} has {} elements for {} joints", *index,
                                              accessor.count, joint_count));
    HM_TRY(take_work(skin, source, std::uint64_t{accessor.count} * sizeof(glm::mat4)));
    HM_TRY_ASSIGN(const std::vector<float> values, read_floats(source, *index));
    HM_TRY(check_finite(source, *index, values));
    for (std::size_t i = 0; i < joint_count; ++i) {
        std::array<double, 16> columns{};
        std::copy_n(values.begin() + std::ptrdiff_t(16 * i), 16, columns.begin());
        const auto matrix = affine_matrix(columns);
        if (!matrix)
            return fail(ErrorKind::invalid, source.file, accessor_pointer(*index),
                        fmt::format("the last row of element {} is not 0 0 0 1", i));
        out[i] = *matrix;
    }
    return out;
}

// One past the last descendant of each node. The scene's nodes are in depth-first order, so a
// subtree is contiguous.
std::vector<int> subtree_ends(const Scene& scene) {
    std::vector<int> end(scene.nodes.size());
    for (std::size_t i = scene.nodes.size(); i-- > 0;) {
        end[i] = std::max(end[i], static_cast<int>(i) + 1);
        const int parent = scene.nodes[i].parent;
        if (parent != kUnset) end[std::size_t(parent)] = std::max(end[std::size_t(parent)], end[i]);
    }
    return end;
}

// The specification requires a common root; rendering does not need it.
void check_hierarchy(const Json& json, Source& source, const Skin& skin, const Scene& scene,
                     const std::vector<int>& ends, int skeleton) {
    const auto [low, high] = std::minmax_element(skin.joints.begin(), skin.joints.end());
    if (*low == kUnset) return;  // reported where the skin is used
    int root = *low;
    while (root != kUnset && ends[std::size_t(root)] <= *high)
        root = scene.nodes[std::size_t(root)].parent;
    if (root == kUnset)
        source.warn(json.pointer_of("joints"), "the joints have no common root");
    else if (skeleton != kUnset && (skeleton > *low || ends[std::size_t(skeleton)] <= *high))
        source.warn(json.pointer_of("skeleton"), "is not a common root of the joints");
}

Result<std::vector<int>> read_joints(const Json& json, const std::vector<int>& scene_node) {
    HM_TRY_ASSIGN(const auto joints, json.indices("joints", scene_node.size(), "nodes"));
    if (joints.empty()) return json.invalid("joints", "a skin must have at least one joint");
    std::vector<int> out;
    std::set<std::size_t> known;
    for (const std::size_t joint : joints) {
        if (!known.insert(joint).second)
            return json.invalid(fmt::format("joints/{}", out.size()),
                                fmt::format("node {} is repeated", joint));
        out.push_back(scene_node[joint]);
    }
    return out;
}

std::uint32_t joints_needed(const Deformation& d) {
    std::uint32_t needed = 0;
    for (std::size_t i = 0; i < d.joints.size(); ++i)
        if (d.weights[i] != 0) needed = std::max(needed, d.joints[i] + 1u);
    return needed;
}

// Why the mesh cannot use the skin; empty if it can.
std::string skin_mismatch(const Mesh& mesh, const Node& node, const Skin& skin) {
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
        if (skin.joints[i] == kUnset)
            return fmt::format("joint {} of skin {} is not in the chosen scene", i, node.skin);
    for (const Primitive& primitive : mesh.primitives) {
        if (!primitive.deformation || primitive.deformation->influences == 0)
            return fmt::format("mesh {} has a primitive without JOINTS_0 and WEIGHTS_0", node.mesh);
        const std::uint32_t needed = joints_needed(*primitive.deformation);
        if (needed > skin.joints.size())
            return fmt::format("mesh {} uses joint {}, but the skin has only {}", node.mesh,
                               needed - 1, skin.joints.size());
    }
    return "";
}

}  // namespace

Result<std::vector<Skin>> read_skins(const Json& root, Source& source,
                                     const std::vector<int>& scene_node, const Scene& scene) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("skins"));
    if (items.empty()) return std::vector<Skin>();
    const std::vector<int> ends = subtree_ends(scene);
    std::vector<Skin> skins;
    for (const Json& item : items) {
        Skin skin;
        HM_TRY_ASSIGN(skin.name, name_of(item));
        HM_TRY_ASSIGN(skin.joints, read_joints(item, scene_node));
        HM_TRY_ASSIGN(skin.inverse_bind, read_inverse_bind(item, source, skin.joints.size()));
        HM_TRY_ASSIGN(const auto skeleton, item.index("skeleton", scene_node.size(), "nodes"));
        check_hierarchy(item, source, skin, scene, ends, skeleton ? scene_node[*skeleton] : kUnset);
        skins.push_back(std::move(skin));
    }
    return skins;
}

Result<void> check_skinned_nodes(const Source& source, const std::vector<int>& scene_node,
                                 const Scene& scene) {
    for (std::size_t i = 0; i < scene_node.size() && !scene.skins.empty(); ++i) {
        if (scene_node[i] == kUnset) continue;
        const Node& node = scene.nodes[std::size_t(scene_node[i])];
        if (node.skin == kUnset) continue;
        std::string wrong = skin_mismatch(scene.meshes[std::size_t(node.mesh)], node,
                                          scene.skins[std::size_t(node.skin)]);
        if (!wrong.empty())
            return fail(ErrorKind::invalid, source.file, fmt::format("/nodes/{}/skin", i),
                        std::move(wrong));
    }
    return {};
}

}  // namespace hm::gltf
