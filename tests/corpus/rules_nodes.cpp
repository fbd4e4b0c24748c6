// Nodes, their transforms and hierarchy, scenes (glTF 2.0, 3.5, 5.25, 5.27).
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

void add_transform_rules(std::vector<Case>& cases) {
    Object node(cases, "node", "3.5.3", "/nodes/0");
    node.numbers("translation", {"0", "0", "0"});
    node.numbers("scale", {"1", "1", "1"});
    node.numbers("rotation", {"0", "0", "0", "1"});
    node.value("translation", "huge", "[1e39,0,0]", "fits a 32-bit float", "")
        .expect(refused("/nodes/0/translation/0", "does not fit a 32-bit float"))
        .silent(kFloatRange);
    node.value("rotation", "above", "[0,0,0,2]", "elements are at most 1", "")
        .expect(ignored("quaternions are scaled to unit length"));
    node.value("rotation", "below", "[0,0,0,-2]", "elements are at least -1", "")
        .expect(ignored("quaternions are scaled to unit length"));
    node.value("rotation", "length", "[0.5,0,0,0.5]", "has unit length", "")
        .expect(ignored("quaternions are scaled to unit length"));
    node.value("rotation", "zero", "[0,0,0,0]", "has unit length", "a zero quaternion");
    node.rule("overflow", "transforms: the world's fits a 32-bit float",
              {set("/nodes/0/scale", "[1e30,1e30,1e30]"),
               set("/nodes/2/matrix", "[1e30,0,0,0,0,1e30,0,0,0,0,1e30,0,0,0,0,1]")},
              refused("/nodes/2", "overflows a 32-bit float"))
        .silent(kFloatRange);
    Object matrix(cases, "node-matrix", "3.5.3", "/nodes/2");
    matrix.numbers(
        "matrix", {"1", "0", "0", "0", "0", "1", "0", "0", "0", "0", "1", "0", "0", "0", "0", "1"});
    for (const char* key : {"translation", "scale"})
        matrix.value(key, "both", "[1,1,1]", "not beside a matrix", "")
            .expect(refused("/nodes/2/matrix", "not both"));
    matrix.value("rotation", "both", "[0,0,0,1]", "not beside a matrix", "")
        .expect(refused("/nodes/2/matrix", "not both"));
    matrix.value("matrix", "projection", "[1,0,0,0.5,0,1,0,0,0,0,1,0,0,0,0,1]",
                 "can be decomposed: its last row is 0 0 0 1", "its last row is not 0 0 0 1");
    matrix
        .value("matrix", "shear", "[1,0,0,0,1,1,0,0,0,0,1,0,0,0,0,1]",
               "can be decomposed: no shear", "")
        .expect(ignored("any affine transform can be drawn"));
    matrix.value("matrix", "zero", "[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]",
                 "can be decomposed: its last row is 0 0 0 1", "its last row is not 0 0 0 1");
}

void add_hierarchy_rules(std::vector<Case>& cases) {
    Object node(cases, "hierarchy", "3.5.2", "/nodes/0");
    node.rule("self", "children: not the node itself", {set("/nodes/3/children", "[3]")},
              refused("/nodes/3", "is its own ancestor"));
    node.rule("cycle", "children: no cycles",
              {set("/nodes/1/children", "[3]"), set("/nodes/3/children", "[1]"),
               set("/nodes/0/children", "[2]"), set("/scenes/0/nodes", "[0]")},
              refused("/nodes/1", "is its own ancestor"));
    node.rule("two-parents", "children: one parent each", {set("/nodes/3/children", "[1]")},
              refused("/nodes/1", "is a child of node 0 and of node 3"));
    node.rule("child-twice", "children: no element twice", {set("/nodes/0/children", "[1,1]")},
              refused("/nodes/1", "is a child of node 0 and of node 0"));
    node.rule("scene-child", "scenes' nodes: are roots", {set("/scenes/0/nodes", "[0,1]")},
              refused("/scenes/0/nodes/1", "node 1 is a child of node 0"));
    node.rule("scene-twice", "scenes' nodes: no element twice", {set("/scenes/0/nodes", "[0,0]")},
              refused("/scenes/0/nodes/1", "node 0 is repeated"));
}

}  // namespace

void add_node_rules(std::vector<Case>& cases) {
    Object node(cases, "node", "5.25", "/nodes/0");
    node.indices("children");
    node.empty("children").expect(ignored(kEmptyIsNone));
    node.text("name");
    node.extensions();
    Object drawn(cases, "node-mesh", "5.25", "/nodes/1");
    drawn.index("mesh");
    drawn.value("skin", "type", R"("0")", "is an integer", "expected an integer, found a string");
    drawn.value("skin", "past-end", "0", "is the index of something that exists",
                "past the end of the 0 skins");
    drawn.value("weights", "type", "1", "is an array", "expected an array, found a number");
    drawn.empty("weights").expect(ignored(kEmptyIsNone));
    drawn.value("weights", "targets", "[1]", "one for each of the mesh's targets",
                "1 weights for 0 morph targets");
    Object viewer(cases, "node-camera", "5.25", "/nodes/2");
    viewer.index("camera");
    Object scene(cases, "scene", "5.27", "/scenes/0");
    scene.indices("nodes");
    scene.empty("nodes").expect(warned("/scenes/0", "the scene is empty", kRepaired));
    scene.common();
    add_transform_rules(cases);
    add_hierarchy_rules(cases);
}

}  // namespace hm::corpus
