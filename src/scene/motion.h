// Where everything will be at the next frame: for motion vectors.
#pragma once

#include <vector>

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

// A pose of the scene, without what poses do not change.
struct PoseRecord {
    std::vector<glm::mat4> world;              // of the nodes
    std::vector<std::vector<vec3>> positions;  // of each mesh's primitives, one mesh after the
                                               // other; empty where nothing deforms them
};

// Of the pose that the scene has now.
PoseRecord record_pose(const Scene& scene);

// Fills flat.aovs with the places that `next` gives to what `flat`, made from `scene`, holds.
void set_next_pose(FlatScene& flat, const Scene& scene, const PoseRecord& next);

}  // namespace hm
