// Light group names: unique, and the same as a linear search from 2 upwards finds.
#include "scene/light_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/scenes.h"

namespace hm {
namespace {

LightGroups groups_of(const std::vector<std::string>& light_names) {
    test::SceneBuilder b;
    for (const std::string& name : light_names) {
        Light light;
        light.name = name;
        b.light(light);
    }
    return find_light_groups(b.scene, test::flatten_quietly(b.scene));
}

TEST(LightGroups, NamesThatAreTakenAreNumbered) {
    const LightGroups groups =
        groups_of({"lamp", "lamp_2", "lamp", "lamp", "a.b", "a b", "", "light_6", "environment"});
    const std::vector<std::string> expected = {"environment", "lamp",         "lamp_2", "lamp_3",
                                               "lamp_4",      "a_b",          "a_b_2",  "light_6",
                                               "light_6_2",   "environment_2"};
    EXPECT_EQ(groups.names, expected);
    // The environment, then each light, then glTF's default material, which is not emissive.
    const std::vector<std::uint32_t> sources = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0};
    EXPECT_EQ(groups.source_groups, sources);
}

// Quadratic time would take seconds here, cubic time would never finish.
TEST(LightGroups, ManyLightsOfOneName) {
    constexpr std::size_t kCount = 20000;
    const LightGroups groups = groups_of(std::vector<std::string>(kCount, "lamp"));
    ASSERT_EQ(groups.names.size(), kCount + 1);
    EXPECT_EQ(std::set(groups.names.begin(), groups.names.end()).size(), kCount + 1);
    EXPECT_EQ(groups.names[1], "lamp");
    EXPECT_EQ(groups.names[kCount], "lamp_20000");
}

// One of the generated names is also the own name of a light.
TEST(LightGroups, ManyLightsBesideANumberedOne) {
    std::vector<std::string> names(1000, "lamp");
    names[0] = "lamp_500";
    const LightGroups groups = groups_of(names);
    EXPECT_EQ(groups.names[1], "lamp_500");
    EXPECT_EQ(groups.names[500], "lamp_499");
    EXPECT_EQ(groups.names[501], "lamp_501");
}

}  // namespace
}  // namespace hm
