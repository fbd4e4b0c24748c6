// A scene from arrays: a wall lit by a directional light, whose radiance is known in closed form.
#include <himalaya/himalaya.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <exception>

using namespace himalaya;

Scene make_scene() {
    constexpr std::array<Vec3, 4> kCorners = {Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{1, 1, 0},
                                              Vec3{-1, 1, 0}};
    constexpr std::array<Triangle, 2> kTriangles = {Triangle{0, 1, 2}, Triangle{0, 2, 3}};
    Scene scene;
    Material paint;
    paint.base_color = {0.8f, 0.4f, 0.2f, 1};
    paint.specular = 0;  // Lambertian
    Mesh wall;
    wall.positions = kCorners;
    wall.triangles = kTriangles;
    wall.material = scene.add_material(paint);
    scene.add_instance(scene.add_mesh(wall));
    Light sun;
    sun.kind = Light::Kind::directional;
    sun.intensity = 3.14159265f;  // W/m^2: the radiance is albedo * intensity / pi
    scene.add_light(sun);
    scene.add_camera({}, translation({0, 0, 2}));
    return scene;
}

int main(int count, char** arguments) {
    try {
        Scene scene = make_scene();
        RenderSettings settings;
        settings.frame.width = settings.frame.height = 64;
        settings.sampling.samples = 16;
        settings.aovs = {"depth"};
        Renderer renderer({.kind = DeviceSettings::Kind::cpu});
        const Picture picture =
            renderer.render(scene, settings, {.progress = [](const Progress&) { return true; }});
        const float* middle = &picture.pixels()[4 * (32 * 64 + 32)];
        const float depth = picture.layer("depth").values[32 * 64 + 32];
        std::printf("%.4f %.4f %.4f at %.4f m\n", double(middle[0]), double(middle[1]),
                    double(middle[2]), double(depth));
        if (count > 1) picture.write(arguments[1]);
    } catch (const std::exception& error) {
        return std::fprintf(stderr, "scene_in_memory: %s\n", error.what()), 1;
    }
}
