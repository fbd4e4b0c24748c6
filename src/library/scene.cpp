#include <himalaya/scene.h>

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "library/errors.h"
#include "library/scene_impl.h"

namespace himalaya {
namespace {

glm::dmat4 matrix_of(const Matrix& matrix) {
    for (const double x : matrix)
        if (!std::isfinite(float(x))) refuse("a transform has a value that is not finite");
    return glm::make_mat4(matrix.data());
}

}  // namespace

Scene::Scene() : impl_(std::make_unique<Impl>()) {}
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;

Scene Scene::load(const std::filesystem::path& gltf, const LoadSettings& settings) {
    return guarded([&] {
        Scene scene;
        Impl& impl = *scene.impl_;
        impl.load = {settings.scene, settings.variant, settings.memory_limit,
                     settings.allow_external};
        hm::Diagnostics diagnostics;
        impl.scene = value_or_throw(hm::load_gltf(gltf, diagnostics, impl.load));
        for (const hm::Warning& warning : diagnostics.warnings())
            impl.warnings.push_back(warning.line());
        return scene;
    });
}

void Scene::add_instance(std::uint32_t mesh, const Matrix& transform, const std::string& name) {
    guarded([&] {
        hm::Scene& scene = impl_->scene;
        if (mesh >= scene.meshes.size()) refuse("there is no mesh with this index");
        hm::Node node;
        node.name = name;
        node.mesh = int(mesh);
        node.local = matrix_of(transform);
        scene.nodes.push_back(std::move(node));
        impl_->lacks_origin = true;
    });
}

void Scene::add_light(const Light& light, const Matrix& transform) {
    guarded([&] {
        hm::Scene& scene = impl_->scene;
        const bool is_finite = std::isfinite(light.color.x + light.color.y + light.color.z) &&
                               std::isfinite(light.intensity) && std::isfinite(light.range);
        if (!is_finite || light.intensity < 0 || light.range < 0 || light.color.x < 0 ||
            light.color.y < 0 || light.color.z < 0)
            refuse("a light has a value that is negative or not finite");
        if (!(light.inner_cone >= 0 && light.inner_cone < light.outer_cone &&
              light.outer_cone <= 1.5707964f))
            refuse("a light's cones must be 0 <= inner < outer <= pi / 2");
        const glm::dmat4 local = matrix_of(transform);
        scene.lights.push_back({.name = light.name,
                                .kind = light.kind == Light::Kind::directional
                                            ? hm::kLightDirectional
                                        : light.kind == Light::Kind::spot ? hm::kLightSpot
                                                                          : hm::kLightPoint,
                                .color = {light.color.x, light.color.y, light.color.z},
                                .intensity = light.intensity,
                                .range = light.range,
                                .inner_cone = light.inner_cone,
                                .outer_cone = light.outer_cone});
        hm::Node node;
        node.name = light.name;
        node.light = int(scene.lights.size()) - 1;
        node.local = local;
        scene.nodes.push_back(std::move(node));
    });
}

void Scene::add_camera(const Camera& camera, const Matrix& transform) {
    guarded([&] {
        hm::Scene& scene = impl_->scene;
        hm::Camera added;
        added.name = camera.name;
        if (camera.half_height) {
            if (!(*camera.half_height > 0 && std::isfinite(*camera.half_height)))
                refuse("a camera's half height must be above 0 and finite");
            added.perspective = false;
            added.xmag = added.ymag = *camera.half_height;
        } else {
            if (!(camera.vertical_fov > 0 && camera.vertical_fov < 180))
                refuse("a camera's field of view must be between 0 and 180 degrees");
            added.yfov = camera.vertical_fov * 0.017453292519943295f;
        }
        const glm::dmat4 local = matrix_of(transform);
        scene.cameras.push_back(added);
        hm::Node node;
        node.name = camera.name;
        node.camera = int(scene.cameras.size()) - 1;
        node.local = local;
        scene.nodes.push_back(std::move(node));
    });
}

const std::vector<std::string>& Scene::warnings() const {
    return impl_->warnings;
}

}  // namespace himalaya
