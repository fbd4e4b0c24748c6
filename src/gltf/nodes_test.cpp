// Node hierarchies: transforms, order, scenes, and graphs that are not trees.
#include <fmt/format.h>

#include <cmath>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

Overrides nodes(const std::string& list, const std::string& roots = "[0]") {
    return {{"nodes", list}, {"scenes", "[{\"nodes\":" + roots + "}]"}};
}

glm::dmat4 local(const std::string& node) {
    const Loaded loaded = load_text(document(nodes("[" + node + "]")));
    EXPECT_TRUE(loaded.scene) << loaded.scene.error().line();
    return loaded.scene ? loaded.scene->nodes.at(0).local : glm::dmat4(0);
}

void expect_near(const glm::mat4& m, vec3 from, vec3 to) {
    const vec4 got = m * vec4(from, 1);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(double(got[i]), double(to[i]), 1e-6);
    EXPECT_EQ(got.w, 1.0f);
}

TEST(Transforms, MatrixAndParts) {
    EXPECT_EQ(local("{}"), glm::dmat4(1));
    const glm::mat4 m = local(R"({"matrix":[1,2,3,0, 4,5,6,0, 7,8,9,0, 10,11,12,1]})");
    EXPECT_EQ(m[0], vec4(1, 2, 3, 0));
    EXPECT_EQ(m[3], vec4(10, 11, 12, 1));
    expect_near(local(R"({"translation":[1,2,3]})"), {1, 1, 1}, {2, 3, 4});
    expect_near(local(R"({"scale":[2,3,4]})"), {1, 1, 1}, {2, 3, 4});
    // pi / 2 about z, x to y; the quaternion is not normalized.
    expect_near(local(R"({"rotation":[0,0,2,2]})"), {1, 0, 0}, {0, 1, 0});
    // About x, y to z; and about y, z to x.
    expect_near(local(R"({"rotation":[1,0,0,1]})"), {0, 1, 0}, {0, 0, 1});
    expect_near(local(R"({"rotation":[0,1,0,1]})"), {0, 0, 1}, {1, 0, 0});
    // Scaled, then rotated, then translated.
    expect_near(local(R"({"translation":[10,0,0],"rotation":[0,0,1,1],"scale":[2,1,1]})"),
                {1, 0, 0}, {10, 2, 0});
}

TEST(Transforms, Refusals) {
    const auto node = [](const char* json) { return nodes(std::string("[") + json + "]"); };
    expect_refused({
        {"both", node(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":[1,1,1]})"),
         "/nodes/0/matrix", "not both"},
        {"fifteen", node(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0]})"), "/nodes/0/matrix",
         "expected 16 numbers, found 15"},
        {"projection", node(R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,-1,0,0,0,0]})"), "/nodes/0/matrix",
         "last row"},
        {"zero quaternion", node(R"({"rotation":[0,0,0,0]})"), "/nodes/0/rotation", "zero"},
        {"three", node(R"({"rotation":[0,0,1]})"), "/nodes/0/rotation", "expected 4"},
        {"overflow", node(R"({"translation":[1e39,0,0]})"), "/nodes/0/translation/0", "float"},
        {"no list", node(R"({"scale":2})"), "/nodes/0/scale", "expected an array"},
        {"product overflows",
         nodes(R"([{"scale":[1e30,1,1],"children":[1]},{"scale":[1e30,1,1]}])"), "/nodes/1",
         "overflows"},
    });
}

TEST(Nodes, ParentsFirstSiblingsInOrder) {
    //      4           2 (a root too)
    //    3   0
    //   1 5
    const Loaded loaded = load_text(
        document(nodes(R"([{"name":"0"},{"name":"1"},{"name":"2"},{"name":"3","children":[1,5]},
                  {"name":"4","children":[3,0]},{"name":"5"},{"name":"left out"}])",
                       "[4,2]")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    std::vector<std::string> names;
    std::vector<int> parents, indices;
    for (const Node& node : loaded.scene->nodes) {
        names.push_back(node.name);
        parents.push_back(node.parent);
        indices.push_back(node.index);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"4", "3", "1", "5", "0", "2"}));
    EXPECT_EQ(parents, (std::vector<int>{-1, 0, 1, 1, 0, -1}));
    EXPECT_EQ(indices, (std::vector<int>{4, 3, 1, 5, 0, 2}));
    EXPECT_EQ(pointer_of(loaded.scene->nodes[0]), "/nodes/4");
}

TEST(Nodes, ScenesAreChosen) {
    const auto names = [](const Overrides& extra) {
        Overrides overrides{
            {"nodes", R"([{"name":"a"},{"name":"b","children":[2]},{"name":"c"}])"}};
        for (const auto& [key, value] : extra)
            overrides[key] = value;
        const Loaded loaded = load_text(document(overrides));
        EXPECT_TRUE(loaded.scene) << loaded.scene.error().line();
        std::string all;
        if (loaded.scene)
            for (const Node& node : loaded.scene->nodes)
                all += node.name;
        return all + " " + std::to_string(loaded.diagnostics.warnings().size());
    };
    const std::string two = R"([{"nodes":[0]},{"nodes":[1]}])";
    EXPECT_EQ(names({{"scenes", two}, {"scene", "1"}}), "bc 0");
    EXPECT_EQ(names({{"scenes", two}, {"scene", "0"}}), "a 0");
    EXPECT_EQ(names({{"scenes", two}, {"scene", ""}}), "a 0");
    EXPECT_EQ(names({{"scenes", ""}, {"scene", ""}}), "abc 1");
    EXPECT_EQ(names({{"scenes", "[{}]"}}), " 1");
}

TEST(Nodes, Refusals) {
    const std::string mesh_light = R"([{"extensions":{"KHR_lights_punctual":)";
    expect_refused({
        {"no such child", nodes(R"([{"children":[1]}])"), "/nodes/0/children/0", "past the end"},
        {"two parents", nodes(R"([{"children":[2]},{"children":[2]},{}])"), "/nodes/2",
         "child of node 0 and of node 1"},
        {"twice", nodes(R"([{"children":[1,1]},{}])"), "/nodes/1", "child of node 0"},
        {"itself", nodes(R"([{"children":[0]}])"), "/nodes/0", "own ancestor"},
        {"cycle", nodes(R"([{},{"children":[2]},{"children":[3]},{"children":[1]}])"), "/nodes/1",
         "own ancestor"},
        {"child of a cycle", nodes(R"([{},{"children":[2]},{"children":[1,0]}])", "[]"), "/nodes/2",
         "own ancestor"},
        {"no such mesh", nodes(R"([{"mesh":1}])"), "/nodes/0/mesh", "past the end of the 1 meshes"},
        {"no such camera", nodes(R"([{"camera":0}])"), "/nodes/0/camera", "past the end of the 0"},
        {"no such light", nodes(mesh_light + R"({"light":0}}}])"),
         "/nodes/0/extensions/KHR_lights_punctual/light", "past the end of the 0"},
        {"no light", nodes(mesh_light + "{}}}]"), "/nodes/0/extensions/KHR_lights_punctual/light",
         "is required"},
        {"no such root", nodes("[{}]", "[1]"), "/scenes/0/nodes/0", "past the end"},
        {"root twice", nodes("[{}]", "[0,0]"), "/scenes/0/nodes/1", "node 0 is repeated"},
        {"root is a child", nodes(R"([{"children":[1]},{}])", "[0,1]"), "/scenes/0/nodes/1",
         "child of node 0"},
        {"no such scene", {{"scene", "1"}}, "/scene", "past the end of the 1 scenes"},
        {"scene without scenes", {{"scenes", ""}}, "/scene", "past the end of the 0"},
        {"name is a number", nodes(R"([{"name":1}])"), "/nodes/0/name", "expected a string"},
    });
}

std::string json_array(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items)
        text += (text.empty() ? "[" : ",") + item;
    return text + "]";
}

TEST(Nodes, ChainsOfAnyDepth) {
    // Every node precedes its parent in the file.
    constexpr std::size_t kCount = 300000;
    std::vector<std::string> list(kCount);
    for (std::size_t i = 0; i + 1 < kCount; ++i)
        list[i + 1] = fmt::format(R"({{"children":[{}]}})", i);
    list[0] = "{}";
    const Loaded loaded =
        load_text(document(nodes(json_array(list), fmt::format("[{}]", kCount - 1))));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    ASSERT_EQ(loaded.scene->nodes.size(), kCount);
    for (std::size_t i = 0; i < kCount; ++i)
        ASSERT_EQ(loaded.scene->nodes[i].parent, static_cast<int>(i) - 1);

    list[0] = fmt::format(R"({{"children":[{}]}})", kCount - 1);
    const Loaded cycle = load_text(document(nodes(json_array(list), "[]")));
    ASSERT_FALSE(cycle.scene);
    EXPECT_EQ(cycle.scene.error().location, "/nodes/0");
}

}  // namespace
}  // namespace hm::gltf_test
