// Procedural textures of the hero scene. Square textures tile.
#pragma once

#include "base/result.h"
#include "gltf_writer.h"

namespace hm {

// Texture indices in the file.
struct HeroTextures {
    int slab_color, slab_normal, slab_roughness;  // paving; one repeat is 2.4 m
    int rock_color, rock_normal;                  // weathered stone; about 1 m
    int plaster_color;                            // whitewash with rain stains
    int hammered_normal;                          // beaten metal
    int flag_color;                               // a printed, frayed prayer flag: alpha mask
    int leaf_color;                               // one leaf: alpha mask
    int scarf_color;                              // woven silk with fringes: alpha blend
    int mist_color;                               // horizontal wisps that fade upwards: alpha blend
};

Result<HeroTextures> add_hero_textures(GltfWriter& writer);

}  // namespace hm
