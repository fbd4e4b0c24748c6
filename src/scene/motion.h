// Transforms and vertex positions at the next frame, for motion vectors.
#pragma once

#include <vector>

#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm {

// A pose of the scene: only the data that posing changes.
struct PoseRecord {
    std::vector<glm::dmat4> world;             // per node
    std::vector<std::vector<vec3>> positions;  // per primitive, mesh by mesh; empty for
                                               // primitives that are not deformed
};

// Records the scene's current pose.
PoseRecord record_pose(const Scene& scene);

// Fills flat.aovs with the transforms and positions of `next` for the instances and geometries of
// `flat`, which was made from `scene`.
void set_next_pose(FlatScene& flat, const Scene& scene, const PoseRecord& next);

}  // namespace hm
