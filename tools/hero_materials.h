// Materials of the hero scene, as indices in the file.
#pragma once

#include "gltf_writer.h"
#include "hero_textures.h"

namespace hm {

struct HeroMaterials {
    int slab, stone, warm_stone, plaster, ochre;
    int gold, copper, brass, celadon, lacquer, cushion, bead, wax;
    int rope, bark, blossom, leaf, grass, conifer, terrain;
    int scarf, glass, mist;
    int flame;
    int flags[5];  // blue, white, red, green, yellow: in hanging order
};

HeroMaterials add_hero_materials(GltfWriter& writer, const HeroTextures& textures,
                                 int terrain_texture);

}  // namespace hm
