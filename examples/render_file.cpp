// Renders a glTF file into a picture: render_file SCENE.glb PICTURE.png
#include <himalaya/himalaya.h>

#include <cstdio>
#include <exception>

int main(int count, char** arguments) {
    if (count != 3) return std::fprintf(stderr, "usage: render_file SCENE.glb PICTURE.png\n"), 2;
    try {
        himalaya::Scene scene = himalaya::Scene::load(arguments[1]);
        himalaya::RenderSettings settings;
        settings.frame.width = settings.frame.height = 128;
        settings.sampling.samples = 16;
        himalaya::Renderer renderer({.kind = himalaya::DeviceSettings::Kind::cpu});
        renderer.render(scene, settings).write(arguments[2]);
    } catch (const std::exception& error) {
        return std::fprintf(stderr, "render_file: %s\n", error.what()), 1;
    }
}
