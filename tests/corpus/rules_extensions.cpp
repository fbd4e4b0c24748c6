// Extensions of materials, textures, meshes and nodes, each according to its own specification.
#include <fmt/format.h>

#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

constexpr char kMistyped[] = "a type that is invalid for this attribute";

void add_material_extensions(std::vector<Case>& cases) {
    Object material(cases, "material", "KHR_materials_emissive_strength",
                    "/materials/0/extensions");
    material.object("KHR_materials_emissive_strength");
    Object strength(cases, "strength", "KHR_materials_emissive_strength",
                    "/materials/0/extensions/KHR_materials_emissive_strength");
    strength.number("emissiveStrength");
    strength.value("emissiveStrength", "negative", "-1", "is at least 0", "must not be negative");
    strength
        .value("emissiveStrength", "huge", "1e39", "fits a 32-bit float",
               "does not fit a 32-bit float")
        .silent(kFloatRange);
    Object unlit(cases, "unlit", "KHR_materials_unlit", "/materials/1/extensions");
    unlit.object("KHR_materials_unlit");

    const std::string slot = "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions";
    Object owner(cases, "slot", "KHR_texture_transform", slot);
    owner.object("KHR_texture_transform");
    Object transform(cases, "transform", "KHR_texture_transform", slot + "/KHR_texture_transform");
    transform.numbers("offset", {"0", "0"});
    transform.numbers("scale", {"1", "1"});
    transform.number("rotation");
    transform.integer("texCoord");
}

void add_variants(std::vector<Case>& cases) {
    const std::string name = "KHR_materials_variants";
    Object root(cases, "variants", name, "/extensions", Base::extended);
    root.object(name);
    Object list(cases, "variants", name, "/extensions/" + name, Base::extended);
    list.required("variants");
    list.objects("variants");
    list.empty("variants")
        .expect(refused("/meshes/0/primitives/0/extensions/" + name + "/mappings/0/variants/0",
                        "past the end of the 0 variants"));
    Object variant(cases, "variant", name, "/extensions/" + name + "/variants/0", Base::extended);
    variant.required("name");
    variant.text("name");
    const std::string pointer = "/meshes/0/primitives/0/extensions";
    Object primitive(cases, "primitive-variants", name, pointer, Base::extended);
    primitive.object(name);
    Object mappings(cases, "primitive-variants", name, pointer + "/" + name, Base::extended);
    mappings.required("mappings");
    mappings.objects("mappings");
    mappings.empty("mappings").expect(ignored(kEmptyIsNone));
    Object mapping(cases, "mapping", name, pointer + "/" + name + "/mappings/0", Base::extended);
    mapping.required("material");
    mapping.index("material");
    mapping.required("variants");
    mapping.indices("variants");
    mapping.empty("variants").expect(ignored(kEmptyIsNone));
    mapping.value("variants", "repeated", "[0,0]", "has no element twice", "variant 0 is repeated");
    mapping.value("variants", "claimed", "[0,1]", "each variant in one mapping only", "")
        .expect(refused(pointer + "/" + name + "/mappings/1/variants", "variant 1 is repeated"));
}

void add_instancing(std::vector<Case>& cases) {
    const std::string name = "EXT_mesh_gpu_instancing";
    Object node(cases, "node-instances", name, "/nodes/0/extensions", Base::extended);
    node.object(name);
    const std::size_t first = cases.size();
    Object instances(cases, "instances", name, "/nodes/0/extensions/" + name, Base::extended);
    instances.required("attributes");
    instances.object("attributes");
    Object attributes(cases, "instances", name, instances.pointer("attributes"), Base::extended);
    for (const char* key : {"TRANSLATION", "ROTATION", "SCALE"})
        attributes.index(key);
    attributes.value("TRANSLATION", "vec4", "3", "VEC3 of floats", kMistyped);
    attributes.value("ROTATION", "vec3", "2", "VEC4 of floats or normalized integers", kMistyped);
    attributes.value("SCALE", "vec4", "3", "VEC3 of floats", kMistyped);
    attributes.rule("count", "all attributes have as many elements",
                    {set("/accessors/4/count", "1")},
                    refused(attributes.pointer("SCALE"), "has 1 elements, another has 2"));
    attributes.rule("no-mesh", "the node has a mesh", {drop("/nodes/0/mesh")},
                    warned("/nodes/0", "instances of a skinned mesh or of no mesh", kSkipped));
    attributes.rule("rotation-zero", "ROTATION: unit length", {put(60, floats({0, 0, 0, 0}))},
                    refused(attributes.pointer("ROTATION"), "element 0 is a zero quaternion"));
    Added(cases, first).silent(kUnknown);
    attributes.rule("translation-nan", "floats: not NaN", {put(36, words({0x7fc00000}))},
                    refused("/accessors/2", "element 0 is NaN"));
}

void add_quantization(std::vector<Case>& cases) {
    const std::string name = "KHR_mesh_quantization";
    Object mesh(cases, "quantized", name, "/meshes/0/primitives/0/attributes", Base::extended);
    mesh.rule("not-required", "integer positions only where the extension is required",
              {drop("/extensionsRequired")}, ignored("exporters forget to require it"));
    mesh.rule("normal-unsigned", "NORMAL: signed and normalized",
              {set("/accessors/1/componentType", "5121")},
              refused(mesh.pointer("NORMAL"), kMistyped));
    mesh.rule("normal-not-normalized", "NORMAL: signed and normalized",
              {set("/accessors/1/normalized", "false")},
              refused(mesh.pointer("NORMAL"), kMistyped));
    mesh.rule("position-uint", "POSITION: integers of 8 or 16 bits",
              {set("/accessors/0/componentType", "5125"), set("/accessors/0/count", "2"),
               set("/accessors/1/count", "2"), set("/bufferViews/0/byteStride", "12")},
              refused(mesh.pointer("POSITION"), kMistyped));
    mesh.rule("unaligned", "strides: multiples of 4",
              {drop("/bufferViews/0/byteStride"), set("/accessors/0/max", "[1,1,0]")},
              warned("/accessors/0", "not aligned to 4 bytes", kDecodable));
}

void add_visibility(std::vector<Case>& cases) {
    const std::string name = "KHR_node_visibility";
    Object node(cases, "visibility", name, "/nodes/0/extensions", Base::extended);
    const auto show = [&](const char* json) {
        return Edits{set("/extensionsUsed/3", '"' + name + '"'), set(node.pointer(name), json)};
    };
    node.rule("type", "KHR_node_visibility: is an object", show("true"),
              refused(node.pointer(name), "expected an object, found a boolean"));
    node.rule("visible-type", "visible: is a boolean", show(R"({"visible":1})"),
              refused(node.pointer(name + "/visible"), "expected a boolean, found a number"))
        .silent(kUnknown);
}

// The animation's first channel, with a pointer as its target.
void add_pointers(std::vector<Case>& cases) {
    const std::string name = "KHR_animation_pointer";
    Object target(cases, "pointer", name, "/animations/0/channels/0/target", Base::moving);
    const auto aim = [&](const std::string& extension) {
        return Edits{set("/extensionsUsed", "[\"" + name + "\"]"),
                     set(target.pointer(""),
                         R"({"path":"pointer","extensions":{")" + name + "\":" + extension + "}}")};
    };
    const std::string pointer = target.pointer("extensions/" + name + "/pointer");
    target.rule("missing", "pointer: is required", aim("{}"), refused(pointer, "is required"));
    target.rule("type", "pointer: is a string", aim(R"({"pointer":7})"),
                refused(pointer, "expected a string, found a number"));
    const std::size_t first = cases.size();
    target.rule("past-end", "pointer: leads to something that exists",
                aim(R"({"pointer":"/nodes/99/translation"})"),
                warned(target.pointer(""), "its target is missing", kSkipped));
    target.rule("undefined", "pointer: the property's object is there",
                aim(R"({"pointer":"/cameras/0/perspective/yfov"})"),
                warned(target.pointer(""), "its target is missing", kSkipped));
    target.rule("immutable", "pointer: leads to a property that may change",
                aim(R"({"pointer":"/nodes/1/mesh"})"),
                warned(target.pointer(""), "or cannot be animated", kSkipped));
    const auto rotate = [&](const char* property) {
        Edits edits = aim(fmt::format(R"({{"pointer":"/nodes/1/{}"}})", property));
        edits.push_back(set("/animations/0/samplers/0/output", "7"));
        return edits;
    };
    target.rule("output", "output: of the property's type", rotate("scale"),
                refused("/animations/0/channels/0/sampler", "a type that is invalid for scale"));
    target.rule("twice", "pointer: no property twice in an animation", rotate("rotation"),
                warned("/animations/0/channels/1/target", "has the same target", kSkipped));
    Added(cases, first).silent(kInPart);
}

}  // namespace

void add_extension_rules(std::vector<Case>& cases) {
    add_material_extensions(cases);
    add_variants(cases);
    add_instancing(cases);
    add_quantization(cases);
    add_visibility(cases);
    add_pointers(cases);
}

}  // namespace hm::corpus
