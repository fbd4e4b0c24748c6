// Scenes built in code: few triangles, known results.
#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "scene/environment.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm::test {

// Pure Lambertian: no specular lobe.
Material lambertian(vec3 albedo);

// Emissive only, reflects nothing.
Material emitter(vec3 radiance);

class SceneBuilder {
  public:
    Scene scene;

    int material(const Material& m);
    int image(std::uint32_t width, std::uint32_t height, const std::vector<vec4>& texels);

    // Meshes. A quad has the corners corner, + u, + u + v, + v, normal cross(u, v), and texture
    // coordinates along u and v. The sphere has radius 1 and its poles on z.
    int quad(vec3 corner, vec3 u, vec3 v, int material);
    int sphere(int segments, int material);
    int mesh(std::vector<Primitive> primitives);
    Primitive quad_primitive(vec3 corner, vec3 u, vec3 v, int material) const;

    int place(int mesh, const glm::mat4& transform = glm::mat4(1));
    int light(const Light& light, const glm::mat4& transform = glm::mat4(1));
};

// Axis-aligned cube of half extent 1 as one mesh, facing inwards or outwards.
int add_cube(SceneBuilder& builder, bool inwards, int material);

// An rgba32f environment map; constant radiance if 1 x 1.
FloatImage environment_image(std::uint32_t width, std::uint32_t height,
                             const std::vector<vec3>& texels);
EnvironmentMap constant_environment(vec3 radiance);

// Flattens and expects no warnings.
FlatScene flatten_quietly(const Scene& scene, EnvironmentMap environment = {},
                          LightChoice choice = {});

}  // namespace hm::test
