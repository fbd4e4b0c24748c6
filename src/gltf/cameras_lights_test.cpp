#include <fmt/format.h>

#include "gltf/test_files.h"

namespace hm::gltf_test {
namespace {

Overrides camera(const std::string& json) {
    return {{"cameras", "[" + json + "]"}};
}

Overrides light(const std::string& json) {
    return {{"extensions", "{\"KHR_lights_punctual\":{\"lights\":[" + json + "]}}"}};
}

TEST(Cameras, Both) {
    Overrides overrides = camera(
        R"({"name":"eye","type":"perspective","perspective":{"yfov":1.5,"znear":0.1,
            "aspectRatio":2}},
           {"type":"orthographic","orthographic":{"xmag":3,"ymag":-2,"znear":0,"zfar":10}},
           {"type":"perspective","perspective":{"yfov":1,"znear":1,"zfar":2}})");
    overrides["nodes"] = R"([{"camera":1}])";
    const Loaded loaded = load_text(document(overrides));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    ASSERT_EQ(loaded.scene->cameras.size(), 3u);
    const Camera& eye = loaded.scene->cameras[0];
    EXPECT_EQ(eye.name, "eye");
    EXPECT_TRUE(eye.perspective);
    EXPECT_EQ(eye.yfov, 1.5f);
    EXPECT_EQ(eye.aspect_ratio, 2.0f);
    const Camera& flat = loaded.scene->cameras[1];
    EXPECT_FALSE(flat.perspective);
    EXPECT_EQ(flat.xmag, 3.0f);
    EXPECT_EQ(flat.ymag, 2.0f);
    EXPECT_EQ(loaded.warned("/cameras/1/orthographic", "negative"), 1u);
    EXPECT_EQ(loaded.scene->cameras[2].aspect_ratio, 0.0f);
    EXPECT_EQ(loaded.scene->nodes[0].camera, 1);
}

TEST(Cameras, Refusals) {
    const auto perspective = [](const char* json) {
        return camera(fmt::format(R"({{"type":"perspective","perspective":{{{}}}}})", json));
    };
    const auto orthographic = [](const char* json) {
        return camera(fmt::format(R"({{"type":"orthographic","orthographic":{{{}}}}})", json));
    };
    expect_refused({
        {"no type", camera("{}"), "/cameras/0/type", "is required"},
        {"fisheye", camera(R"({"type":"fisheye"})"), "/cameras/0/type",
         "\"fisheye\" is not a camera type"},
        {"no body", camera(R"({"type":"perspective"})"), "/cameras/0/perspective", "is required"},
        {"no yfov", perspective(R"("znear":1)"), "/cameras/0/perspective/yfov", "is required"},
        {"no znear", perspective(R"("yfov":1)"), "/cameras/0/perspective/znear", "is required"},
        {"no ymag", orthographic(R"("xmag":1,"znear":0,"zfar":1)"), "/cameras/0/orthographic/ymag",
         "is required"},
        {"no zfar", orthographic(R"("xmag":1,"ymag":1,"znear":0)"), "/cameras/0/orthographic/zfar",
         "is required"},
    });
}

TEST(Cameras, UnusableOnesStayInTheScene) {
    const struct {
        const char* json;
        const char* pointer;
        bool usable;
    } cases[] = {
        {R"("perspective":{"znear":1,"yfov":0})", "/perspective/yfov", false},
        {R"("perspective":{"znear":1,"yfov":3.1416})", "/perspective/yfov", false},
        {R"("perspective":{"znear":1,"yfov":1,"aspectRatio":0})", "/perspective/aspectRatio", true},
        {R"("orthographic":{"xmag":0,"ymag":0,"znear":0,"zfar":1})", "/orthographic/xmag", false},
        {R"("orthographic":{"xmag":1,"ymag":0,"znear":0,"zfar":1})", "/orthographic/ymag", false},
    };
    for (const auto& c : cases) {
        const bool perspective = std::string_view(c.json).starts_with(R"("perspective)");
        const Loaded loaded = load_text(document(camera(fmt::format(
            R"({{"type":"{}",{}}})", perspective ? "perspective" : "orthographic", c.json))));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        ASSERT_EQ(loaded.diagnostics.warnings().size(), 1u) << c.json;
        const std::string pointer = std::string("/cameras/0") + c.pointer;
        EXPECT_EQ(loaded.diagnostics.warnings()[0].location, pointer);
        const Camera& read = loaded.scene->cameras.at(0);
        EXPECT_EQ(read.fault.has_value(), !c.usable) << c.json;
        EXPECT_EQ(read.fault ? read.fault->location : pointer, pointer);
    }
}

TEST(Cameras, InvalidPlanesAreIgnored) {
    for (const char* json :
         {R"({"type":"perspective","perspective":{"yfov":1,"znear":0}})",
          R"({"type":"perspective","perspective":{"yfov":1,"znear":1,"zfar":1}})",
          R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":-1,"zfar":1}})",
          R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0,"zfar":0}})"}) {
        const Loaded loaded = load_text(document(camera(json)));
        ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
        ASSERT_EQ(loaded.diagnostics.warnings().size(), 1u) << json;
        EXPECT_NE(loaded.diagnostics.warnings()[0].message.find("znear"), std::string::npos);
    }
}

TEST(Lights, AllKinds) {
    Overrides overrides = light(
        R"({"type":"directional"},
           {"name":"bulb","type":"point","color":[1,0.5,0],"intensity":20,"range":5},
           {"type":"spot","spot":{}},
           {"type":"spot","spot":{"innerConeAngle":0.25,"outerConeAngle":1.5707963267948966}})");
    overrides["nodes"] = R"([{"extensions":{"KHR_lights_punctual":{"light":1}}}])";
    const Loaded loaded = load_text(document(overrides));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    EXPECT_TRUE(loaded.diagnostics.warnings().empty());
    const std::vector<Light>& lights = loaded.scene->lights;
    ASSERT_EQ(lights.size(), 4u);
    EXPECT_EQ(lights[0].kind, kLightDirectional);
    EXPECT_EQ(lights[0].color, vec3(1));
    EXPECT_EQ(lights[0].intensity, 1.0f);
    EXPECT_EQ(lights[0].range, 0.0f);
    EXPECT_EQ(lights[1].name, "bulb");
    EXPECT_EQ(lights[1].kind, kLightPoint);
    EXPECT_EQ(lights[1].color, vec3(1, 0.5f, 0));
    EXPECT_EQ(lights[1].intensity, 20.0f);
    EXPECT_EQ(lights[1].range, 5.0f);
    EXPECT_EQ(lights[2].kind, kLightSpot);
    EXPECT_EQ(lights[2].inner_cone, 0.0f);
    EXPECT_NEAR(double(lights[2].outer_cone), 0.785398163, 1e-7);
    EXPECT_EQ(lights[3].inner_cone, 0.25f);
    EXPECT_EQ(loaded.scene->nodes[0].light, 1);
}

TEST(Lights, ToleratedWithAWarning) {
    const Loaded loaded = load_text(document(light(
        R"({"type":"spot","color":[2,1,1],"spot":{"innerConeAngle":0.5,"outerConeAngle":0.5}})")));
    ASSERT_TRUE(loaded.scene) << loaded.scene.error().line();
    const std::string pointer = "/extensions/KHR_lights_punctual/lights/0";
    EXPECT_EQ(loaded.warned(pointer + "/spot", "edge is hard"), 1u);
    EXPECT_EQ(loaded.warned(pointer + "/color", "used as is"), 1u);
    EXPECT_EQ(loaded.scene->lights[0].color, vec3(2, 1, 1));
}

TEST(Lights, Refusals) {
    const std::string at = "/extensions/KHR_lights_punctual/lights/0";
    const struct {
        const char* json;
        const char* pointer;
        const char* message;
    } cases[] = {
        {"{}", "/type", "is required"},
        {R"({"type":"area"})", "/type", "\"area\" is not a light type"},
        {R"({"type":"point","color":[1,-1,1]})", "/color", "negative"},
        {R"({"type":"point","color":[1,1]})", "/color", "expected 3"},
        {R"({"type":"point","intensity":-1})", "/intensity", "negative"},
        {R"({"type":"point","color":[1,1,1],"intensity":3e38})", "/intensity", "float"},
        {R"({"type":"point","range":0})", "/range", "positive"},
        {R"({"type":"spot"})", "/spot", "is required"},
        {R"({"type":"spot","spot":{"innerConeAngle":-1}})", "/spot/innerConeAngle", "negative"},
        {R"({"type":"spot","spot":{"innerConeAngle":1}})", "/spot/outerConeAngle", "greater than"},
        {R"({"type":"spot","spot":{"outerConeAngle":1.6}})", "/spot/outerConeAngle", "pi / 2"},
        {R"({"type":"spot","spot":{"outerConeAngle":0}})", "/spot/outerConeAngle", "greater than"},
    };
    for (const auto& c : cases)
        expect_refused({{c.json, light(c.json), (at + c.pointer).c_str(), c.message}});
}

}  // namespace
}  // namespace hm::gltf_test
