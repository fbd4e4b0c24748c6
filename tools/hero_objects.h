// The hero scene's objects: shrine, prayer flags, wall, table with vessels, and the landscape.
#pragma once

#include "gltf_writer.h"
#include "hero_materials.h"

namespace hm {

// Adds meshes, sharing geometry where possible, and nodes that place them.
class HeroBuilder {
  public:
    HeroBuilder(GltfWriter& writer, const HeroMaterials& materials)
        : writer_(writer), materials_(materials) {}

    void add_terrace();     // paving, parapet, pebbles, grass
    void add_shrine();      // a chorten: steps, dome, gilded spire
    void add_flags();       // two lines of prayer flags from the spire
    void add_still_life();  // table, bowl, ewer, vase, butter lamps, beads, scarf
    void add_lanterns();    // brass and glass, a candle in each
    void add_landscape();   // terrain, mist, trees

  private:
    int single_mesh(const std::string& name, const TriangleMesh& mesh, int material);
    void place(const std::string& name, int mesh, glm::vec3 position, float yaw = 0,
               glm::vec3 scale = glm::vec3(1));
    int make_lantern_mesh();
    void add_parapet();
    void add_pebbles();
    void add_grass();
    void add_flag_line(glm::vec3 from, glm::vec3 to, float sag, int count);
    void add_table();
    void add_branch();
    int make_butter_lamp_mesh();

    GltfWriter& writer_;
    const HeroMaterials& materials_;
};

}  // namespace hm
