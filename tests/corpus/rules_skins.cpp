// Skins, joints and weights, morph targets (glTF 2.0, 3.7.2.2, 3.7.3, 5.28).
#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

constexpr char kMistyped[] = "a type that is invalid for this attribute";
constexpr char kAttributes[] = "/meshes/0/primitives/0/attributes";

void add_influence_rules(std::vector<Case>& cases) {
    Object attributes(cases, "influences", "3.7.3.3", kAttributes, Base::moving);
    attributes.index("JOINTS_0");
    attributes.index("WEIGHTS_0");
    const auto refuse = [&](const char* slug, const char* rule, Edits edits, const char* key,
                            const char* message) {
        attributes.rule(slug, rule, std::move(edits), refused(attributes.pointer(key), message));
    };
    refuse("joints-missing", "JOINTS_0 and WEIGHTS_0: both or none",
           {drop(attributes.pointer("JOINTS_0"))}, "WEIGHTS_0", "is present without JOINTS_0");
    refuse("weights-missing", "JOINTS_0 and WEIGHTS_0: both or none",
           {drop(attributes.pointer("WEIGHTS_0"))}, "JOINTS_0", "is present without WEIGHTS_0");
    refuse("joints-type", "JOINTS_0: vectors of four unsigned integers",
           {set(attributes.pointer("JOINTS_0"), "3")}, "JOINTS_0", kMistyped);
    refuse("joints-signed", "JOINTS_0: vectors of four unsigned integers",
           {set("/accessors/2/componentType", "5120")}, "JOINTS_0", kMistyped);
    refuse("joints-normalized", "JOINTS_0: not normalized",
           {set("/accessors/2/normalized", "true")}, "JOINTS_0", kMistyped);
    refuse("weights-type", "WEIGHTS_0: vectors of four",
           {set(attributes.pointer("WEIGHTS_0"), "0")}, "WEIGHTS_0", kMistyped);
    refuse("weights-integers", "WEIGHTS_0: integers are normalized",
           {set(attributes.pointer("WEIGHTS_0"), "2")}, "WEIGHTS_0", kMistyped);
    refuse("joints-count", "JOINTS_0: as many elements as POSITION",
           {set("/accessors/2/count", "2")}, "JOINTS_0", "has 2 elements, POSITION has 3");
    refuse("set-gap", "JOINTS and WEIGHTS: sets are numbered without gaps",
           {set(attributes.pointer("JOINTS_2"), "2"), set(attributes.pointer("WEIGHTS_2"), "3")},
           "WEIGHTS_2", "without gaps");
    attributes.rule("joint-past-end", "JOINTS_0: below the count of the skin's joints",
                    {put(73, "\2")},
                    refused("/nodes/0/skin", "uses joint 2, but the skin has only 2"));
    attributes
        .rule("joint-unused", "JOINTS_0: 0 where the weight is 0", {put(74, "\1")},
              ignored("a joint without a weight moves nothing"))
        .silent(kOnlyWarns);
    const char* const primitive = "/meshes/0/primitives/0";
    attributes.rule("joint-twice", "JOINTS_0: no joint twice with a weight above 0",
                    {put(73, std::string(1, '\0'))},
                    warned(primitive, "list a joint more than once", kRepaired));
    attributes.rule("weight-negative", "WEIGHTS_0: not negative", {put(84, floats({-0.5f, 1.5f}))},
                    refused("/accessors/3", "element 0 has the negative weight -0.5"));
    attributes.rule("weight-sum", "WEIGHTS_0: add up to 1", {put(84, floats({0.5f, 0.25f}))},
                    warned(primitive, "do not sum to one", kRepaired));
}

void add_target_rules(std::vector<Case>& cases) {
    Object primitive(cases, "targets", "3.7.2.2", "/meshes/0/primitives/0", Base::moving);
    primitive.objects("targets");
    primitive.empty("targets").expect(refused("/meshes/0/weights", "1 weights for 0 morph"));
    Object target(cases, "target", "3.7.2.2", "/meshes/0/primitives/0/targets/0", Base::moving);
    target.index("POSITION");
    primitive.rule("empty-target", "targets: each has at least one attribute",
                   {set(target.pointer(""), "{}")}, ignored(kEmptyIsNone));
    primitive.rule("target-attribute", "targets: POSITION, NORMAL, TANGENT, TEXCOORD_n, COLOR_n",
                   {set(target.pointer("JOINTS_0"), "2")}, ignored(kUnread));
    primitive.rule("target-base", "targets: only attributes that the primitive has",
                   {set(target.pointer("NORMAL"), "1")},
                   refused(target.pointer("NORMAL"), "the primitive does not have this attribute"));
    primitive.rule("target-count", "targets: as many elements as the primitive's",
                   {set("/accessors/1/count", "2"), set("/accessors/1/max", "[0,0,0]")},
                   refused(target.pointer("POSITION"), "has 2 elements, POSITION has 3"));
    primitive.rule("target-type", "targets: positions are float vectors of three",
                   {set(target.pointer("POSITION"), "3")},
                   refused(target.pointer("POSITION"), "a type that is invalid for this delta"));
    primitive.rule("target-integers", "targets: integers only with KHR_mesh_quantization",
                   {set("/accessors/1/componentType", "5122"),
                    set("/bufferViews/1/byteStride", "8"), set("/accessors/1/max", "[0,0,0]")},
                   refused(target.pointer("POSITION"), "a type that is invalid for this delta"));
    primitive.rule("target-no-limits", "targets: positions have min and max",
                   {drop("/accessors/1/min")},
                   warned("/accessors/1", "min and max are missing", kRepaired));
    primitive.rule("targets-differ", "targets: all primitives have as many",
                   {set("/meshes/0/primitives/1", R"({"attributes":{"POSITION":0}})")},
                   refused("/meshes/0/primitives", "one has 1 morph targets, another has 0"));
    for (const char* pointer : {"/meshes/0", "/nodes/0"}) {
        Object owner(cases, pointer[1] == 'm' ? "mesh-weights" : "node-weights",
                     pointer[1] == 'm' ? "5.23" : "5.25", pointer, Base::moving);
        owner.value("weights", "type", "0.5", "is an array", "expected an array, found a number");
        owner.value("weights", "element-type", R"(["0"])", "elements are numbers", "")
            .expect(refused(owner.pointer("weights/0"), "expected a number, found a string"));
        owner.empty("weights").expect(refused(owner.pointer("weights"), "0 weights for 1 morph"));
        owner.value("weights", "count", "[1,1]", "one for each target", "2 weights for 1 morph");
    }
    Object node(cases, "node-weights", "5.25", "/nodes/1", Base::moving);
    node.value("weights", "no-mesh", "[1]", "only with a mesh", "1 weights for 0 morph targets");
}

}  // namespace

void add_skin_rules(std::vector<Case>& cases) {
    Object skin(cases, "skin", "5.28", "/skins/0", Base::moving);
    const Expected none = refused("/skins/0/joints", "must have at least one joint");
    skin.required("joints").expect(none);
    skin.indices("joints");
    skin.empty("joints").expect(none);
    skin.value("joints", "repeated", "[1,2,1]", "has no element twice", "")
        .expect(refused("/skins/0/joints/2", "node 1 is repeated"));
    skin.index("inverseBindMatrices");
    skin.index("skeleton");
    skin.common();
    skin.value("inverseBindMatrices", "vectors", "3", "MAT4 of floats", "must be MAT4 of floats");
    skin.rule("matrices-count", "inverseBindMatrices: one for each joint",
              {set("/accessors/4/count", "1")},
              refused("/skins/0/inverseBindMatrices", "has 1 elements for 2 joints"));
    skin.rule("matrices-row", "inverseBindMatrices: the last row is 0 0 0 1",
              {put(132 + 12, floats({1}))},
              refused("/accessors/4", "the last row of element 0 is not 0 0 0 1"));
    skin.rule("matrices-nan", "inverseBindMatrices: not NaN", {put(132, words({0x7fc00000}))},
              refused("/accessors/4", "element 0 is NaN"));
    skin.rule("no-common-root", "joints: have a common root",
              {drop("/nodes/1/children"), set("/scenes/0/nodes", "[0,1,2]")},
              warned("/skins/0/joints", "no common root", kRepaired));
    Object node(cases, "node-skin", "5.25", "/nodes/0", Base::moving);
    node.index("skin");
    node.rule("no-mesh", "skin: only with a mesh", {set("/nodes/2/skin", "0")},
              refused("/nodes/2/skin", "a node with a skin must have a mesh"));
    node.rule("no-joints", "skin: the mesh has JOINTS_0 and WEIGHTS_0",
              {set("/meshes/0/primitives/0/attributes", R"({"POSITION":0})")},
              refused("/nodes/0/skin", "a primitive without JOINTS_0 and WEIGHTS_0"));
    add_influence_rules(cases);
    add_target_rules(cases);
}

}  // namespace hm::corpus
