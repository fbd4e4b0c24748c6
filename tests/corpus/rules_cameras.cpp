// Cameras (glTF 2.0, 3.10, 5.12 to 5.14) and KHR_lights_punctual.
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

void positive(Object& object, std::string_view key, const Expected& expected) {
    object.value(key, "zero", "0", "is greater than 0", "").expect(expected);
    object.value(key, "negative", "-1", "is greater than 0", "").expect(expected);
}

// A camera that no picture can be rendered through; others can.
Expected unusable(const Object& view, std::string_view key) {
    return warned(view.pointer(key), "the camera cannot be used", kSkipped);
}

Expected invalid_planes(const Object& view) {
    return warned(view.pointer(""), "invalid znear or zfar", kUnread);
}

// The renderer does not clip at these planes.
void add_plane_rules(Object& view) {
    for (const char* value : {"0", "-1"}) {
        const char* slug = *value == '0' ? "zero" : "negative";
        view.value("zfar", slug, value, "is greater than 0", "").expect(invalid_planes(view));
    }
}

void add_perspective_rules(std::vector<Case>& cases) {
    Object view(cases, "perspective", "5.14", "/cameras/0/perspective");
    for (const char* key : {"yfov", "znear"}) {
        view.required(key);
        view.number(key);
    }
    view.number("aspectRatio");
    view.number("zfar");
    positive(view, "yfov", unusable(view, "yfov"));
    view.value("yfov", "pi", "3.2", "is less than pi", "")
        .expect(unusable(view, "yfov"))
        .silent(kOnlyWarns);
    positive(view, "aspectRatio", warned(view.pointer("aspectRatio"), "not positive", kUnread));
    view.value("znear", "zero", "0", "is greater than 0", "").expect(invalid_planes(view));
    view.value("znear", "negative", "-1", "is greater than 0", "").expect(invalid_planes(view));
    add_plane_rules(view);
    view.value("zfar", "below-znear", "0.05", "is greater than znear", "")
        .expect(invalid_planes(view));
    view.common(false);
}

void add_orthographic_rules(std::vector<Case>& cases) {
    Object view(cases, "orthographic", "5.13", "/cameras/1/orthographic");
    for (const char* key : {"xmag", "ymag", "znear", "zfar"}) {
        view.required(key);
        view.number(key);
    }
    for (const char* key : {"xmag", "ymag"}) {
        view.value(key, "zero", "0", "is not 0", "").expect(unusable(view, key));
        view.value(key, "negative", "-1", "should not be negative", "")
            .expect(warned(view.pointer(""), "negative magnification", kRepaired))
            .silent(kOnlyWarns);
    }
    view.value("znear", "negative", "-1", "is at least 0", "").expect(invalid_planes(view));
    add_plane_rules(view);
    view.rule("zfar-below-znear", "zfar: is greater than znear",
              {set("/cameras/1/orthographic/znear", "11")}, invalid_planes(view));
    view.common(false);
}

}  // namespace

void add_camera_rules(std::vector<Case>& cases) {
    Object camera(cases, "camera", "5.12", "/cameras/0");
    camera.required("type");
    camera.text("type");
    camera.unlisted("type", "unknown", R"("fisheye")", "is perspective or orthographic",
                    "is not a camera type");
    camera.required("perspective");
    camera.object("perspective");
    camera.rule("other-kind", "perspective and orthographic: not both",
                {set("/cameras/0/orthographic", R"({"xmag":1,"ymag":1,"znear":0,"zfar":1})")},
                ignored("the type tells which is meant"));
    camera.rule("type-differs", "type: its property is there",
                {set("/cameras/0/type", R"("orthographic")")},
                refused("/cameras/0/orthographic", "is required"));
    camera.common();
    add_perspective_rules(cases);
    add_orthographic_rules(cases);
}

void add_light_rules(std::vector<Case>& cases) {
    const std::string lights = "/extensions/KHR_lights_punctual";
    Object extension(cases, "lights", "KHR_lights_punctual", lights);
    extension.required("lights").expect(
        refused("/nodes/3/extensions/KHR_lights_punctual/light", "past the end of the 0 lights"));
    extension.objects("lights");
    extension.empty("lights").expect(
        refused("/nodes/3/extensions/KHR_lights_punctual/light", "past the end of the 0 lights"));
    Object root(cases, "lights", "KHR_lights_punctual", "/extensions");
    root.object("KHR_lights_punctual");

    Object light(cases, "light", "KHR_lights_punctual", lights + "/lights/0");
    light.required("type");
    light.text("type");
    light.unlisted("type", "unknown", R"("area")", "is directional, point or spot",
                   "is not a light type");
    light.numbers("color", {"1", "1", "1"});
    light.value("color", "below", "[-1,1,1]", "elements are at least 0", "must not be negative");
    light.value("color", "above", "[1,2,1]", "elements are at most 1", "")
        .expect(warned(light.pointer("color"), "above 1", kRepaired));
    light.number("intensity");
    light.value("intensity", "negative", "-1", "is at least 0", "must not be negative");
    light.value("intensity", "huge", "1e39", "fits a 32-bit float", "does not fit a 32-bit float")
        .silent(kFloatRange);
    light.number("range");
    positive(light, "range", refused(light.pointer("range"), "must be positive"));
    light
        .rule("range-directional", "range: not on directional lights",
              {set(lights + "/lights/2/range", "1")}, ignored(kUnread))
        .silent(kOnlyWarns);
    light.common();

    Object spot(cases, "spot", "KHR_lights_punctual", lights + "/lights/1/spot");
    spot.number("innerConeAngle");
    spot.value("innerConeAngle", "negative", "-0.1", "is at least 0", "must not be negative");
    spot.value("innerConeAngle", "above", "0.6", "is less than outerConeAngle", "")
        .expect(refused(spot.pointer("outerConeAngle"), "must be greater than innerConeAngle"));
    spot.value("innerConeAngle", "equal", "0.5", "is less than outerConeAngle", "")
        .expect(warned(spot.pointer(""), "the cone angles are equal", kRepaired));
    spot.number("outerConeAngle");
    spot.value("outerConeAngle", "zero", "0", "is greater than 0", "must be greater than");
    spot.value("outerConeAngle", "above", "1.6", "is at most pi / 2", "must not be greater than");
    Object owner(cases, "light-spot", "KHR_lights_punctual", lights + "/lights/1");
    owner.required("spot");
    owner.object("spot");
    Object node(cases, "node-light", "KHR_lights_punctual",
                "/nodes/3/extensions/KHR_lights_punctual");
    node.required("light");
    node.index("light");
    Object extensions(cases, "node-light", "KHR_lights_punctual", "/nodes/3/extensions");
    extensions.object("KHR_lights_punctual");
}

}  // namespace hm::corpus
