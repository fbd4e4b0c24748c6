// Skins, joints and weights, morph targets (glTF 2.0, 3.7.2.2, 3.7.3, 5.28).
#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

constexpr char kAttributes[] = "/meshes/0/primitives/0/attributes";

void add_influence_rules(std::vector<Case>& cases) {
    Object attributes(cases, "influences", "3.7.3.3", kAttributes, Base::moving);
    attributes.always(pending("skins"));
    attributes.index("JOINTS_0");
    attributes.index("WEIGHTS_0");
    attributes.rule("joints-missing", "JOINTS_0 and WEIGHTS_0: both or none",
                    {drop(std::string(kAttributes) + "/JOINTS_0")}, {});
    attributes.rule("weights-missing", "JOINTS_0 and WEIGHTS_0: both or none",
                    {drop(std::string(kAttributes) + "/WEIGHTS_0")}, {});
    attributes.rule("joints-type", "JOINTS_0: vectors of four unsigned integers",
                    {set(std::string(kAttributes) + "/JOINTS_0", "3")}, {});
    attributes.rule("joints-signed", "JOINTS_0: vectors of four unsigned integers",
                    {set("/accessors/2/componentType", "5120")}, {});
    attributes.rule("joints-normalized", "JOINTS_0: not normalized",
                    {set("/accessors/2/normalized", "true")}, {});
    attributes.rule("weights-type", "WEIGHTS_0: vectors of four",
                    {set(std::string(kAttributes) + "/WEIGHTS_0", "0")}, {});
    attributes.rule("weights-integers", "WEIGHTS_0: integers are normalized",
                    {set(std::string(kAttributes) + "/WEIGHTS_0", "2")}, {});
    attributes.rule("joints-count", "JOINTS_0: as many elements as POSITION",
                    {set("/accessors/2/count", "2")}, {});
    attributes.rule("joint-past-end", "JOINTS_0: below the count of the skin's joints",
                    {put(73, "\2")}, {});
    attributes.rule("joint-unused", "JOINTS_0: 0 where the weight is 0", {put(74, "\1")}, {})
        .silent(kOnlyWarns);
    attributes.rule("joint-twice", "JOINTS_0: no joint twice with a weight above 0",
                    {put(73, std::string(1, '\0'))}, {});
    attributes.rule("weight-negative", "WEIGHTS_0: not negative", {put(84, floats({-0.5f, 1.5f}))},
                    {});
    attributes.rule("weight-sum", "WEIGHTS_0: add up to 1", {put(84, floats({0.5f, 0.25f}))}, {});
    attributes.rule("set-gap", "JOINTS and WEIGHTS: sets are numbered without gaps",
                    {set(std::string(kAttributes) + "/JOINTS_2", "2"),
                     set(std::string(kAttributes) + "/WEIGHTS_2", "3")},
                    {});
}

void add_target_rules(std::vector<Case>& cases) {
    Object primitive(cases, "targets", "3.7.2.2", "/meshes/0/primitives/0", Base::moving);
    primitive.always(pending("morph targets"));
    primitive.objects("targets");
    primitive.empty("targets");
    primitive.rule("empty-target", "targets: each has at least one attribute",
                   {set("/meshes/0/primitives/0/targets/0", "{}")}, {});
    primitive.rule("target-attribute", "targets: POSITION, NORMAL, TANGENT, TEXCOORD_n, COLOR_n",
                   {set("/meshes/0/primitives/0/targets/0/JOINTS_0", "2")}, {});
    primitive.rule("target-base", "targets: only attributes that the primitive has",
                   {set("/meshes/0/primitives/0/targets/0/NORMAL", "1")}, {});
    primitive.rule("target-count", "targets: as many elements as the primitive's",
                   {set("/accessors/1/count", "2"), set("/accessors/1/max", "[0,0,0]")}, {});
    primitive.rule("target-type", "targets: positions are float vectors of three",
                   {set("/meshes/0/primitives/0/targets/0/POSITION", "3")}, {});
    primitive.rule("targets-differ", "targets: all primitives have as many",
                   {set("/meshes/0/primitives/1", R"({"attributes":{"POSITION":0}})")}, {});
    Object target(cases, "target", "3.7.2.2", "/meshes/0/primitives/0/targets/0", Base::moving);
    target.always(pending("morph targets"));
    target.index("POSITION");
    Object mesh(cases, "mesh-weights", "5.23", "/meshes/0", Base::moving);
    mesh.always(pending("morph targets"));
    mesh.value("weights", "type", "0.5", "is an array", "");
    mesh.value("weights", "element-type", R"(["0"])", "elements are numbers", "");
    mesh.empty("weights");
    mesh.value("weights", "count", "[1,1]", "one for each target", "");
    Object node(cases, "node-weights", "5.25", "/nodes/0", Base::moving);
    node.always(pending("morph targets"));
    node.value("weights", "type", "0.5", "is an array", "");
    node.value("weights", "element-type", R"(["0"])", "elements are numbers", "");
    node.empty("weights");
    node.value("weights", "count", "[1,1]", "one for each of the mesh's targets", "");
    node.rule("no-mesh", "weights: only with a mesh", {set("/nodes/1/weights", "[1]")}, {});
}

}  // namespace

void add_skin_rules(std::vector<Case>& cases) {
    Object skin(cases, "skin", "5.28", "/skins/0", Base::moving);
    skin.always(pending("skins"));
    skin.required("joints");
    skin.indices("joints");
    skin.empty("joints");
    skin.value("joints", "repeated", "[1,2,1]", "has no element twice", "");
    skin.index("inverseBindMatrices");
    skin.index("skeleton");
    skin.common();
    skin.rule("matrices-type", "inverseBindMatrices: MAT4 of floats",
              {set("/skins/0/inverseBindMatrices", "3")}, {});
    skin.rule("matrices-count", "inverseBindMatrices: one for each joint",
              {set("/accessors/4/count", "1")}, {});
    skin.rule("matrices-row", "inverseBindMatrices: the last row is 0 0 0 1",
              {put(132 + 12, floats({1}))}, {});
    skin.rule("matrices-nan", "inverseBindMatrices: not NaN", {put(132, words({0x7fc00000}))}, {});
    skin.rule("no-common-root", "joints: have a common root",
              {drop("/nodes/1/children"), set("/scenes/0/nodes", "[0,1,2]")}, {});
    Object node(cases, "node-skin", "5.25", "/nodes/0", Base::moving);
    node.always(pending("skins"));
    node.index("skin");
    node.rule("no-mesh", "skin: only with a mesh", {set("/nodes/2/skin", "0")}, {});
    node.rule("no-joints", "skin: the mesh has JOINTS_0 and WEIGHTS_0",
              {set("/meshes/0/primitives/0/attributes", R"({"POSITION":0})")}, {});
    add_influence_rules(cases);
    add_target_rules(cases);
}

}  // namespace hm::corpus
