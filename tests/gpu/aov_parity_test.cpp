// All AOVs of the feature scene on both devices: planes, and the ids that pixels saw.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "gpu/path_tracer.h"
#include "gpu/renderers.h"
#include "scene/light_groups.h"
#include "scene/motion.h"

namespace hm::test {

namespace {

AovSelection everything(const TestScene& scene, FlatScene& flat) {
    AovSelection selection;
    for (const AovInfo& info : all_aovs())
        selection.aovs.push_back(info.aov);
    LightGroups groups = find_light_groups(scene.scene, flat);
    selection.light_groups = groups.names;
    flat.aovs.source_groups = groups.source_groups;
    return selection;
}

// Values of the lowest sample index that hit come from one sample, the others are sums of 16.
std::size_t pixels_off(const FilmPlane& a, const FilmPlane& b) {
    std::size_t off = 0;
    for (std::size_t i = 0; i < a.values.size(); i += a.floats) {
        bool same = true;
        for (std::size_t k = i; k < i + a.floats; ++k) {
            const float x = a.values[k];
            const float y = b.values[k];
            same &= std::abs(x - y) <= 1e-2f * std::max(std::abs(x), std::abs(y)) + 1e-3f;
        }
        off += same ? 0u : 1u;
    }
    return off;
}

bool same_ids(const IdList& a, const IdList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](auto& x, auto& y) {
        return x.id == y.id && std::abs(x.count - y.count) <= 1;
    });
}

TEST(AovParity, EveryPlaneAndEveryId) {
    TestScene scene;
    const AovSelection selection = everything(scene, scene.flat);
    Scene next = scene.scene;
    for (Node& node : next.nodes)
        node.local = glm::translate(glm::mat4(1), vec3(0.2f, 0.1f, 0)) * glm::mat4(node.local);
    set_next_pose(scene.flat, scene.scene, record_pose(next));
    RenderJob job = make_job(scene.flat, scene.camera);
    job.next_camera = job.camera;

    Duel duel(scene.flat);
    const PixelRect crop = {3, 5, 60, 61};
    Film gpu(crop, selection);
    Film cpu(crop, selection);
    draw_into(duel.gpu(), job, gpu);
    draw_into(duel.cpu(), job, cpu);
    expect_same_picture(means_of(gpu), means_of(cpu), "with all AOVs");
    expect_no_messages();
    ASSERT_EQ(gpu.planes.size(), cpu.planes.size());
    for (std::size_t p = 0; p < cpu.planes.size(); ++p) {
        const std::size_t off = pixels_off(gpu.planes[p], cpu.planes[p]);
        std::printf("%-20s %zu of %zu pixels off\n", cpu.planes[p].name.data(), off,
                    cpu.sums.size());
        EXPECT_LE(off, cpu.sums.size() / 50) << cpu.planes[p].name;
        EXPECT_TRUE(std::any_of(cpu.planes[p].values.begin(), cpu.planes[p].values.end(),
                                [](float x) { return x != 0; }))
            << cpu.planes[p].name;
    }
    std::size_t off = 0;
    for (std::size_t i = 0; i < cpu.ids.size(); ++i)
        off += same_ids(gpu.ids[i], cpu.ids[i]) ? 0u : 1u;
    std::printf("%-20s %zu of %zu pixels off\n", "ids", off, cpu.ids.size());
    EXPECT_EQ(gpu.ids.size(), cpu.ids.size());
    EXPECT_LE(off, cpu.ids.size() / 100);
}

}  // namespace

}  // namespace hm::test
