// The extensions of materials, textures, meshes and nodes, each by its own specification.
#include "corpus/bases.h"
#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

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
    root.always(pending(name));
    root.object(name);
    Object list(cases, "variants", name, "/extensions/" + name, Base::extended);
    list.always(pending(name));
    list.required("variants");
    list.objects("variants");
    list.empty("variants");
    Object variant(cases, "variant", name, "/extensions/" + name + "/variants/0", Base::extended);
    variant.always(pending(name));
    variant.required("name");
    variant.text("name");
    const std::string place = "/meshes/0/primitives/0/extensions";
    Object primitive(cases, "primitive-variants", name, place, Base::extended);
    primitive.always(pending(name));
    primitive.object(name);
    Object mappings(cases, "primitive-variants", name, place + "/" + name, Base::extended);
    mappings.always(pending(name));
    mappings.required("mappings");
    mappings.objects("mappings");
    mappings.empty("mappings");
    Object mapping(cases, "mapping", name, place + "/" + name + "/mappings/0", Base::extended);
    mapping.always(pending(name));
    mapping.required("material");
    mapping.index("material");
    mapping.required("variants");
    mapping.indices("variants");
    mapping.empty("variants");
    mapping.value("variants", "repeated", "[0,0]", "has no element twice", "");
    mapping.value("variants", "claimed", "[0,1]", "each variant in one mapping only", "");
}

void add_instancing(std::vector<Case>& cases) {
    const std::string name = "EXT_mesh_gpu_instancing";
    Object node(cases, "node-instances", name, "/nodes/0/extensions", Base::extended);
    node.always(pending(name));
    node.object(name);
    const std::size_t first = cases.size();
    Object instances(cases, "instances", name, "/nodes/0/extensions/" + name, Base::extended);
    instances.always(pending(name));
    instances.required("attributes");
    instances.object("attributes");
    Object attributes(cases, "instances", name, instances.place("attributes"), Base::extended);
    attributes.always(pending(name));
    for (const char* key : {"TRANSLATION", "ROTATION", "SCALE"})
        attributes.index(key);
    attributes.value("TRANSLATION", "vec4", "3", "VEC3 of floats", "");
    attributes.value("ROTATION", "vec3", "2", "VEC4 of floats or normalized integers", "");
    attributes.value("SCALE", "vec4", "3", "VEC3 of floats", "");
    attributes.rule("count", "all attributes have as many elements",
                    {set("/accessors/4/count", "1")}, {});
    attributes.rule("no-mesh", "the node has a mesh", {drop("/nodes/0/mesh")}, {});
    attributes.rule("rotation-zero", "ROTATION: unit length", {put(60, floats({0, 0, 0, 0}))}, {});
    Added(cases, first).silent(kUnknown);
    attributes.rule("translation-nan", "floats: not NaN", {put(36, words({0x7fc00000}))}, {});
}

void add_quantization(std::vector<Case>& cases) {
    const std::string name = "KHR_mesh_quantization";
    Object mesh(cases, "quantized", name, "/meshes/0/primitives/0/attributes", Base::extended);
    mesh.always(pending(name));
    mesh.rule("not-required", "integer positions only where the extension is required",
              {drop("/extensionsRequired")}, {});
    mesh.rule("normal-unsigned", "NORMAL: signed and normalized",
              {set("/accessors/1/componentType", "5121")}, {});
    mesh.rule("normal-not-normalized", "NORMAL: signed and normalized",
              {set("/accessors/1/normalized", "false")}, {});
    mesh.rule("position-uint", "POSITION: integers of 8 or 16 bits",
              {set("/accessors/0/componentType", "5125"), set("/accessors/0/count", "2"),
               set("/accessors/1/count", "2")},
              {});
    mesh.rule("unaligned", "strides: multiples of 4", {drop("/bufferViews/0/byteStride")}, {});
}

}  // namespace

void add_extension_rules(std::vector<Case>& cases) {
    add_material_extensions(cases);
    add_variants(cases);
    add_instancing(cases);
    add_quantization(cases);
}

}  // namespace hm::corpus
