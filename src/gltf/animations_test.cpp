// Animations and morph targets in files: their interpretation and rejected files.
#include <cmath>

#include "gltf/test_accessors.h"
#include "scene/pose.h"

namespace hm::gltf_test {
namespace {

std::string animation(const std::string& target, const std::string& sampler) {
    return R"([{"name":"a","channels":[{"sampler":0,"target":)" + target + R"(}],"samplers":[)" +
           sampler + "]}]";
}

std::string sampler(std::size_t input, std::size_t output, const char* interpolation = "LINEAR") {
    return fmt::format(R"({{"input":{},"output":{},"interpolation":"{}"}})", input, output,
                       interpolation);
}

std::string node_target(const char* path) {
    return std::string(R"({"node":0,"path":")") + path + "\"}";
}

vec3 moved_origin(const Scene& scene) {
    return vec3(scene.nodes.at(0).local * vec4(0, 0, 0, 1));
}

TEST(Animations, TranslationMovesTheNode) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {1, 3});
    const auto values = more.floats("VEC3", 2, {0, 0, 0, 4, 8, 0});
    Loaded loaded = load_text(document(more.with(
        {{"nodes", R"([{"mesh":0,"translation":[9,9,9]}])"},
         {"animations", animation(node_target("translation"), sampler(times, values))}})));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());
    EXPECT_EQ(moved_origin(*loaded.scene), vec3(9, 9, 9));  // the rest pose
    ASSERT_TRUE(pose_scene(*loaded.scene, PoseTime{{0}, 1.5}));
    EXPECT_EQ(moved_origin(*loaded.scene), vec3(1, 2, 0));
    ASSERT_TRUE(pose_scene(*loaded.scene, PoseTime{{0}, 100}));
    EXPECT_EQ(moved_origin(*loaded.scene), vec3(4, 8, 0));
    ASSERT_TRUE(pose_scene(*loaded.scene, std::nullopt));
    EXPECT_EQ(moved_origin(*loaded.scene), vec3(9, 9, 9));
}

TEST(Animations, RotationsOfNormalizedShorts) {
    Accessors more;
    const auto times = more.floats("SCALAR", 1, {0});
    const auto values =
        more.add<std::int16_t>("VEC4", 5122, 1, {0, 0, 32767, 0}, R"(,"normalized":true)");
    Loaded loaded = load_text(document(more.with(
        {{"animations", animation(node_target("rotation"), sampler(times, values, "STEP"))}})));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    ASSERT_TRUE(pose_scene(*loaded.scene, PoseTime{{0}, 0}));
    const vec4 x = loaded.scene->nodes[0].local * vec4(1, 0, 0, 1);
    EXPECT_NEAR(double(x.x), -1, 1e-6);  // rotated by pi
}

TEST(Animations, Refusals) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {1, 3});
    const auto values = more.floats("VEC3", 2, {0, 0, 0, 4, 8, 0});
    const auto three = more.floats("VEC3", 3, {0, 0, 0, 0, 0, 0, 0, 0, 0});
    const auto zeros = more.floats("VEC4", 2, {0, 0, 0, 1, 0, 0, 0, 0});
    const auto bytes = more.add<std::uint8_t>("VEC3", 5121, 2, {0, 0, 0, 0, 0, 0});
    const auto with = [&](const std::string& target, const std::string& s) {
        return more.with({{"animations", animation(target, s)}});
    };
    const std::string move = node_target("translation");
    const std::string twice = R"({"sampler":0,"target":)" + move + "}";
    const std::string good = sampler(times, values);
    const std::string still = R"([{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])";
    Overrides matrix = with(move, good);
    matrix["nodes"] = still;
    expect_refused({
        {"no such node", with(R"({"node":1,"path":"scale"})", good),
         "/animations/0/channels/0/target/node", "past the end"},
        {"no path", with(R"({"node":0})", good), "/animations/0/channels/0/target/path",
         "required"},
        {"matrix", matrix, "/animations/0/channels/0/target/node", "matrix"},
        {"no targets", with(node_target("weights"), good), "/animations/0/channels/0/target/node",
         "morph targets"},
        {"no such sampler",
         more.with({{"animations", R"([{"samplers":[],"channels":[)" + twice + "]}]"}}),
         "/animations/0/channels/0/sampler", "past the end"},
        {"times of vectors", with(move, sampler(values, values)), "/animations/0/samplers/0/input",
         "float scalars"},
        {"one key too many", with(move, sampler(times, three)), "/animations/0/channels/0/sampler",
         "3 elements, expected 2"},
        {"spline of two", with(move, sampler(times, values, "CUBICSPLINE")),
         "/animations/0/channels/0/sampler", "2 elements, expected 6"},
        {"interpolation", with(move, sampler(times, values, "linear")),
         "/animations/0/samplers/0/interpolation", "not an interpolation"},
        {"output of bytes", with(move, sampler(times, bytes)), "/animations/0/channels/0/sampler",
         "type"},
        {"rotation of three", with(node_target("rotation"), good),
         "/animations/0/channels/0/sampler", "type"},
        {"zero rotation", with(node_target("rotation"), sampler(times, zeros)), "/accessors/9",
         "zero quaternion"},
        {"no input", with(move, R"({"output":7})"), "/animations/0/samplers/0/input", "required"},
    });
}

// A node's x at `seconds` with keys that the specification forbids, and the number of warnings.
struct Repaired {
    float x;
    std::size_t warnings;
};
Repaired play(const std::vector<float>& times, const std::vector<float>& xs,
              const char* interpolation, double seconds) {
    Accessors more;
    std::vector<float> values;
    for (const float x : xs)
        values.insert(values.end(), {x, 0, 0});
    const auto input = more.floats("SCALAR", times.size(), times);
    const auto output = more.floats("VEC3", xs.size(), values);
    Loaded loaded = load_text(
        document(more.with({{"animations", animation(node_target("translation"),
                                                     sampler(input, output, interpolation))}})));
    if (!loaded.scene || !pose_scene(*loaded.scene, PoseTime{{0}, seconds})) return {-99, 99};
    return {moved_origin(*loaded.scene).x, loaded.diagnostics.warnings().size()};
}

TEST(Animations, HarmlessFaultsOfKeysAreRepaired) {
    const auto expect = [](Repaired got, float x, std::size_t warnings) {
        EXPECT_EQ(got.x, x);
        EXPECT_EQ(got.warnings, warnings);
    };
    expect(play({-1, 1}, {0, 8}, "LINEAR", 0.5), 6, 1);
    expect(play({-1, 1}, {0, 8}, "LINEAR", 0), 4, 1);
    expect(play({2}, {7, 5, 9}, "CUBICSPLINE", 0), 5, 0);
    expect(play({2}, {7, 5, 9}, "CUBICSPLINE", 3), 5, 0);
    const std::vector<float> jump{0, 1, 1, 2};
    expect(play(jump, {0, 2, 4, 8}, "LINEAR", 0.5), 1, 1);
    expect(play(jump, {0, 2, 4, 8}, "LINEAR", 1), 4, 1);
    expect(play(jump, {0, 2, 4, 8}, "LINEAR", 1.5), 6, 1);
    expect(play({2, 0, 1}, {8, 0, 2}, "LINEAR", 1.5), 5, 1);  // sorted: 0, 2, 8
    expect(play({1, 0}, {0, 6, 0, 0, 2, 0}, "CUBICSPLINE", 0), 2, 1);
    // Keys with a NaN or an infinity are dropped, and the channel with its last key.
    const float nan = std::nanf(""), infinity = INFINITY;
    expect(play({0, 1, 2}, {0, nan, 4}, "LINEAR", 1), 2, 1);
    // Times have two warnings, as NaN and infinity cannot be in the accessor's min and max.
    expect(play({0, nan, 2}, {0, 9, 4}, "LINEAR", 1), 2, 2);
    expect(play({1, infinity, 2}, {7, 0, 4}, "LINEAR", 0), 7, 2);
    expect(play({0, 1, 2}, {0, 0, 0, 0, 9, nan, 0, 4, 0}, "CUBICSPLINE", 1), 2, 1);
    expect(play({0, 1}, {nan, nan}, "LINEAR", 1), 0, 2);
}

TEST(Animations, TheFirstChannelOfATargetPlays) {
    Accessors more;
    const auto times = more.floats("SCALAR", 1, {0});
    const auto one = more.floats("VEC3", 1, {1, 0, 0});
    const auto two = more.floats("VEC3", 1, {2, 0, 0});
    const std::string target = R"(,"target":)" + node_target("translation") + "}";
    Loaded loaded = load_text(document(
        more.with({{"animations", R"([{"samplers":[)" + sampler(times, one) + "," +
                                      sampler(times, two) + R"(],"channels":[{"sampler":0)" +
                                      target + R"(,{"sampler":1)" + target + "]}]"}})));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_EQ(loaded.warned("/animations/0/channels/1/target", "same target"), 1u);
    ASSERT_TRUE(pose_scene(*loaded.scene, PoseTime{{0}, 0}));
    EXPECT_EQ(moved_origin(*loaded.scene), vec3(1, 0, 0));
}

TEST(Animations, PlayTogether) {
    Accessors more;
    const auto times = more.floats("SCALAR", 2, {0, 2});
    const auto right = more.floats("VEC3", 2, {0, 0, 0, 4, 0, 0});
    const auto up = more.floats("VEC3", 2, {0, 0, 0, 0, 8, 0});
    const auto twice = more.floats("VEC3", 2, {2, 2, 2, 2, 2, 2});
    const auto list = [](const std::string& json) { return json.substr(1, json.size() - 2); };
    const std::string move = node_target("translation");
    Loaded loaded = load_text(document(
        more.with({{"animations", "[" + list(animation(move, sampler(times, right))) + "," +
                                      list(animation(node_target("scale"), sampler(times, twice))) +
                                      "," + list(animation(move, sampler(times, up))) + "]"}})));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    Scene& scene = *loaded.scene;
    EXPECT_EQ(count_shared_targets(scene), 1u);
    const auto corner = [&](std::vector<std::size_t> animations) {
        EXPECT_TRUE(pose_scene(scene, PoseTime{std::move(animations), 1}));
        return vec3(scene.nodes.at(0).local * vec4(1, 0, 0, 1));
    };
    EXPECT_EQ(corner({0}), vec3(3, 0, 0));
    EXPECT_EQ(corner({0, 1}), vec3(4, 0, 0));
    EXPECT_EQ(corner({0, 1, 2}), vec3(2, 4, 0));  // the last translation wins
}

std::string morphed_mesh(const std::string& targets, const std::string& rest = "") {
    return R"([{"primitives":[{"indices":3,"attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":4},)"
           R"("targets":)" +
           targets + "}]" + rest + "}]";
}

TEST(MorphTargets, SparseAndNormalizedDeltas) {
    Accessors more;
    const auto index = more.add<std::uint16_t>("SCALAR", 5123, 1, {2});  // view 6
    const auto value = more.floats("VEC3", 1, {5, 6, 7});                // view 7
    const auto color = more.add<std::int8_t>(
        "VEC4", 5120, 3, {-127, 0, 0, 0, 0, -127, 0, 0, 0, 0, -127, 0}, R"(,"normalized":true)");
    ASSERT_EQ(color, 8u);
    Overrides all = more.with(
        {{"meshes", morphed_mesh(R"([{"POSITION":9},{"COLOR_0":8}])", R"(,"weights":[2,1])")}});
    std::string& accessors = all["accessors"];
    accessors.pop_back();
    accessors += fmt::format(R"(,{{"componentType":5126,"type":"VEC3","count":3,"sparse":{{
        "count":1,"indices":{{"bufferView":{},"componentType":5123}},
        "values":{{"bufferView":{}}}}}}}])",
                             index, value);
    const Loaded loaded = load_text(document(all));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const Primitive& p = loaded.scene->meshes[0].primitives[0];
    EXPECT_EQ(p.vertices[0].position, vec3(0, 0, 0));
    EXPECT_EQ(p.vertices[2].position, vec3(10, 14, 14));  // (0, 2, 0) + 2 (5, 6, 7)
    EXPECT_EQ(p.extras[0].color, vec4(0, 0, 0.2f, 1));    // red removed
    EXPECT_EQ(p.deformation->targets[0].positions.size(), 1u);
}

TEST(MorphTargets, NodesWithOtherWeightsGetMeshesOfTheirOwn) {
    Accessors more;
    const auto delta = more.floats("VEC3", 3, {1, 0, 0, 1, 0, 0, 1, 0, 0});
    const auto times = more.floats("SCALAR", 1, {0});
    const auto weights = more.floats("SCALAR", 1, {4});
    const Loaded loaded = load_text(document(more.with(
        {{"meshes",
          morphed_mesh(fmt::format(R"([{{"POSITION":{}}}])", delta), R"(,"weights":[2])")},
         {"nodes", R"([{"mesh":0},{"mesh":0,"weights":[3]},{"mesh":0},{"mesh":0}])"},
         {"scenes", R"([{"nodes":[0,1,2,3]}])"},
         {"animations",
          animation(R"({"node":3,"path":"weights"})", sampler(times, weights, "STEP"))}})));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    Scene scene = *loaded.scene;
    EXPECT_EQ(scene.meshes.size(), 3u);
    EXPECT_EQ(scene.nodes[0].mesh, scene.nodes[2].mesh);
    const auto x = [&](std::size_t node) {
        return scene.meshes[std::size_t(scene.nodes[node].mesh)]
            .primitives[0]
            .vertices[0]
            .position.x;
    };
    EXPECT_EQ(x(0), 2);
    EXPECT_EQ(x(1), 3);
    EXPECT_EQ(x(3), 2);
    ASSERT_TRUE(pose_scene(scene, PoseTime{{0}, 0}));
    EXPECT_EQ(x(0), 2);
    EXPECT_EQ(x(1), 3);
    EXPECT_EQ(x(3), 4);
}

TEST(MorphTargets, Refusals) {
    Accessors more;
    more.floats("VEC3", 2, {0, 0, 0, 0, 0, 0});           // 6
    more.floats("VEC3", 3, {0, 0, 0, 0, 0, 0, 0, 0, 0});  // 7
    const auto with = [&](const std::string& targets, const std::string& rest = "") {
        return more.with({{"meshes", morphed_mesh(targets, rest)}});
    };
    Overrides uneven = with(R"([{"POSITION":7}])");
    uneven["meshes"] = R"([{"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":7}]},
        {"attributes":{"POSITION":0}}]}])";
    Overrides node = with(R"([{"POSITION":7}])");
    node["nodes"] = R"([{"mesh":0,"weights":[]}])";
    expect_refused({
        {"count", with(R"([{"POSITION":6}])"), "/meshes/0/primitives/0/targets/0/POSITION",
         "2 elements, POSITION has 3"},
        {"type", with(R"([{"POSITION":2}])"), "/meshes/0/primitives/0/targets/0/POSITION", "type"},
        {"no base", with(R"([{"TANGENT":7}])"), "/meshes/0/primitives/0/targets/0/TANGENT",
         "does not have this attribute"},
        {"past the end", with(R"([{"POSITION":99}])"), "/meshes/0/primitives/0/targets/0/POSITION",
         "past the end"},
        {"weights of the mesh", with(R"([{"POSITION":7}])", R"(,"weights":[1,2])"),
         "/meshes/0/weights", "2 weights for 1"},
        {"weights of the node", node, "/nodes/0/weights", "0 weights for 1"},
        {"not the same number", uneven, "/meshes/0/primitives", "1 morph targets, another has 0"},
    });
}

}  // namespace
}  // namespace hm::gltf_test
