// The main demo scene: a shrine on a stone terrace above a misty valley, with snow peaks in the
// evening sun, and a table with objects of various materials.
#include "hero_materials.h"
#include "hero_objects.h"
#include "hero_sky.h"
#include "hero_terrain.h"
#include "scenes.h"

namespace hm {

Result<void> write_hero(const std::filesystem::path& folder) {
    GltfWriter writer;
    HM_TRY_ASSIGN(const HeroTextures textures, add_hero_textures(writer));
    HM_TRY_ASSIGN(const int terrain_texture, writer.add_texture("terrain color", paint_terrain()));
    const HeroMaterials materials = add_hero_materials(writer, textures, terrain_texture);

    HeroBuilder builder(writer, materials);
    builder.add_terrace();
    builder.add_shrine();
    builder.add_flags();
    builder.add_still_life();
    builder.add_lanterns();
    builder.add_landscape();

    writer.add_node({.name = "sun",
                     .rotation = look_rotation(hero_sun_direction(), glm::vec3(0)),
                     .light = writer.add_directional_light("sun", {1, 0.68f, 0.39f}, 6.8f)});
    const glm::vec3 eye(0, 1.46f, 6.1f);
    writer.add_node({.name = "camera",
                     .translation = eye,
                     .rotation = look_rotation(eye, {0.05f, 1.45f, 0}),
                     .camera = writer.add_camera("camera", 0.60f, 16.0f / 9, 0.05f)});
    HM_TRY(write_hero_sky(folder / "hero_sky.hdr"));
    return write_scene(
        folder, "hero", writer,
        {{"size", "1280x720"}, {"spp", "64"}, {"env", "hero_sky.hdr"}, {"exposure", "0.15"}});
}

}  // namespace hm
