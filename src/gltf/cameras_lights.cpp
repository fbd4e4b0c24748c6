#include "gltf/cameras_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.h"
#include "scene/choice_names.h"

namespace hm::gltf {
namespace {

constexpr float kPi = 3.14159265358979f;

Result<float> required_number(const Json& json, std::string_view key) {
    return json.required(key, json.number(key));
}

// There is no clipping, so invalid planes are harmless.
void check_planes(const Json& json, Source& source, bool near_is_valid, float near,
                  std::optional<float> far) {
    if (!near_is_valid || (far && *far <= near))
        source.warn(json.pointer(), "invalid znear or zfar; there is no clipping");
}

// The camera stays in the scene, but only pictures through other cameras can be rendered.
void mark_unusable(Source& source, Camera& camera, tl::unexpected<Error> fault) {
    camera.fault = std::move(fault.value());
    source.warn(camera.fault->location, camera.fault->message + "; the camera cannot be used");
}

Result<void> read_perspective(const Json& json, Source& source, Camera& camera) {
    camera.perspective = true;
    HM_TRY_ASSIGN(camera.yfov, required_number(json, "yfov"));
    if (camera.yfov <= 0 || camera.yfov >= kPi)
        mark_unusable(source, camera,
                      json.invalid("yfov", fmt::format("{} is not between 0 and pi", camera.yfov)));
    HM_TRY_ASSIGN(const auto aspect_ratio, json.number("aspectRatio"));
    if (aspect_ratio && *aspect_ratio <= 0)
        source.warn(json.pointer_of("aspectRatio"), "not positive; that of the image is used");
    camera.aspect_ratio = std::max(aspect_ratio.value_or(0), 0.0f);
    HM_TRY_ASSIGN(const float near, required_number(json, "znear"));
    HM_TRY_ASSIGN(const auto far, json.number("zfar"));
    check_planes(json, source, near > 0, near, far);
    return {};
}

Result<void> read_orthographic(const Json& json, Source& source, Camera& camera) {
    camera.perspective = false;
    HM_TRY_ASSIGN(camera.xmag, required_number(json, "xmag"));
    HM_TRY_ASSIGN(camera.ymag, required_number(json, "ymag"));
    for (const auto& [key, value] : {std::pair("xmag", camera.xmag), {"ymag", camera.ymag}})
        if (value == 0 && !camera.fault) mark_unusable(source, camera, json.invalid(key, "is 0"));
    if (camera.xmag < 0 || camera.ymag < 0)
        source.warn(json.pointer(), "negative magnification; its absolute value is used");
    camera.xmag = std::abs(camera.xmag);
    camera.ymag = std::abs(camera.ymag);
    HM_TRY_ASSIGN(const float near, required_number(json, "znear"));
    HM_TRY_ASSIGN(const float far, required_number(json, "zfar"));
    check_planes(json, source, near >= 0, near, far);
    return {};
}

Result<Camera> read_camera(const Json& item, Source& source) {
    Camera camera;
    HM_TRY_ASSIGN(camera.name, name_of(item));
    HM_TRY_ASSIGN(const std::string_view type, item.required("type", item.text("type")));
    if (type != "perspective" && type != "orthographic")
        return item.invalid("type", fmt::format("{} is not a camera type", excerpt(type)));
    HM_TRY_ASSIGN(const Json json, item.required(type, item.object(type)));
    if (type == "perspective")
        HM_TRY(read_perspective(json, source, camera));
    else
        HM_TRY(read_orthographic(json, source, camera));
    return camera;
}

Result<void> read_spot(const Json& item, Source& source, Light& light) {
    HM_TRY_ASSIGN(const Json spot, item.required("spot", item.object("spot")));
    HM_TRY_ASSIGN(light.inner_cone, spot.number_or("innerConeAngle", 0));
    HM_TRY_ASSIGN(light.outer_cone, spot.number_or("outerConeAngle", kPi / 4));
    if (light.inner_cone < 0) return spot.invalid("innerConeAngle", "must not be negative");
    // Tolerates pi / 2 rounded up.
    if (light.outer_cone > kPi / 2 * 1.000001f)
        return spot.invalid("outerConeAngle", "must not be greater than pi / 2");
    if (light.outer_cone < light.inner_cone || light.outer_cone <= 0)
        return spot.invalid("outerConeAngle", "must be greater than innerConeAngle");
    // The extension forbids it, but files use it for hard-edged spots, and the meaning is clear.
    if (light.outer_cone == light.inner_cone)
        source.warn(spot.pointer(), "the cone angles are equal; the edge is hard");
    return {};
}

Result<Light> read_light(const Json& item, Source& source) {
    Light light;
    HM_TRY_ASSIGN(light.name, name_of(item));
    HM_TRY_ASSIGN(const std::string_view type, item.required("type", item.text("type")));
    const auto kind = find_choice(kLightKindNames, type);
    if (!kind) return item.invalid("type", fmt::format("{} is not a light type", excerpt(type)));
    light.kind = *kind;

    std::array<float, 3> color{1, 1, 1};
    HM_TRY(item.numbers("color", color));
    for (const float component : color) {
        if (component < 0) return item.invalid("color", "must not be negative");
        if (component > 1) source.warn(item.pointer_of("color"), "above 1, used as is");
    }
    light.color = vec3(color[0], color[1], color[2]);
    HM_TRY_ASSIGN(light.intensity, item.number_or("intensity", 1));
    if (light.intensity < 0) return item.invalid("intensity", "must not be negative");
    const vec3 power = light.color * light.intensity;
    if (!std::isfinite(power.x + power.y + power.z))
        return item.invalid("intensity", "times the colour does not fit a 32-bit float");
    HM_TRY_ASSIGN(const auto range, item.number("range"));
    if (range && *range <= 0) return item.invalid("range", "must be positive");
    light.range = range.value_or(0);
    if (light.kind == kLightSpot) HM_TRY(read_spot(item, source, light));
    return light;
}

}  // namespace

Result<std::vector<Camera>> read_cameras(const Json& root, Source& source) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("cameras"));
    std::vector<Camera> cameras;
    for (const Json& item : items) {
        HM_TRY_ASSIGN(Camera camera, read_camera(item, source));
        cameras.push_back(std::move(camera));
    }
    return cameras;
}

Result<std::vector<Light>> read_lights(const Json& root, Source& source) {
    std::vector<Light> lights;
    HM_TRY_ASSIGN(const auto extension, extension_of(root, "KHR_lights_punctual"));
    if (!extension) return lights;
    HM_TRY_ASSIGN(const std::vector<Json> items, extension->objects("lights"));
    for (const Json& item : items) {
        HM_TRY_ASSIGN(Light light, read_light(item, source));
        lights.push_back(std::move(light));
    }
    return lights;
}

}  // namespace hm::gltf
