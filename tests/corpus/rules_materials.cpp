// Materials and their texture slots (glTF 2.0, 3.9, 5.19 to 5.22, 5.30).
#include <fmt/format.h>

#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

// A number with limits: values below and above them.
void add_limits(Object& object, std::string_view key, const char* below, const char* above) {
    object.number(key);
    Added huge =
        object.value(key, "huge", "1e300", "fits a 32-bit float", "does not fit a 32-bit float");
    if (above == nullptr) huge.silent(kFloatRange);
    object.value(key, "below", below, "is not less than its minimum", "")
        .expect(warned(object.pointer(key), "", kClamped));
    if (above != nullptr)
        object.value(key, "above", above, "is not more than its maximum", "")
            .expect(warned(object.pointer(key), "clamped", kClamped));
}

void add_slot(std::vector<Case>& cases, const std::string& parent, const std::string& key) {
    Object owner(cases, "material", "5.19", parent);
    owner.object(key);
    Object slot(cases, key, "5.30", parent + "/" + key);
    slot.required("index");
    slot.index("index");
    slot.integer("texCoord");
    slot.value("extensions", "type", "[]", "is an object", "expected an object, found an array");
}

void add_metallic_roughness(std::vector<Case>& cases) {
    Object pbr(cases, "pbr", "5.22", "/materials/0/pbrMetallicRoughness");
    pbr.numbers("baseColorFactor", {"1", "1", "1", "1"});
    pbr.value("baseColorFactor", "below", "[-0.5,1,1,1]", "elements are at least 0", "")
        .expect(warned(pbr.pointer("baseColorFactor"), "outside 0 to 1", kClamped));
    pbr.value("baseColorFactor", "above", "[1,1,1,1.5]", "elements are at most 1", "")
        .expect(warned(pbr.pointer("baseColorFactor"), "outside 0 to 1", kClamped));
    add_limits(pbr, "metallicFactor", "-0.1", "1.1");
    add_limits(pbr, "roughnessFactor", "-0.1", "1.1");
    pbr.common(false);
    add_slot(cases, "/materials/0/pbrMetallicRoughness", "baseColorTexture");
    add_slot(cases, "/materials/0/pbrMetallicRoughness", "metallicRoughnessTexture");
}

}  // namespace

void add_material_rules(std::vector<Case>& cases) {
    Object material(cases, "material", "5.19", "/materials/0");
    material.object("pbrMetallicRoughness");
    material.numbers("emissiveFactor", {"1", "1", "1"});
    material.value("emissiveFactor", "below", "[-1,0,0]", "elements are at least 0",
                   "must not be negative");
    material.value("emissiveFactor", "above", "[2,0,0]", "elements are at most 1", "")
        .expect(warned("/materials/0/emissiveFactor", "outside 0 to 1", kClamped));
    material.text("alphaMode");
    material.unlisted("alphaMode", "unknown", R"("CLIP")", "is OPAQUE, MASK or BLEND",
                      "is not an alpha mode");
    material.unlisted("alphaMode", "case", R"("mask")", "is OPAQUE, MASK or BLEND",
                      "is not an alpha mode");
    add_limits(material, "alphaCutoff", "-1", nullptr);
    material
        .rule("alphaCutoff-mode", "alphaCutoff: only with alphaMode",
              {drop("/materials/0/alphaMode")}, ignored("the mode is OPAQUE then"))
        .silent(kOnlyWarns);
    material.flag("doubleSided");
    material.text("name");
    material.extensions();
    add_metallic_roughness(cases);
    for (const char* slot : {"normalTexture", "occlusionTexture", "emissiveTexture"})
        add_slot(cases, "/materials/0", slot);
    Object normal(cases, "normalTexture", "5.20", "/materials/0/normalTexture");
    normal.number("scale");
    normal.value("scale", "huge", "-1e39", "fits a 32-bit float", "does not fit a 32-bit float")
        .silent(kFloatRange);
    Object occlusion(cases, "occlusionTexture", "5.21", "/materials/0/occlusionTexture");
    add_limits(occlusion, "strength", "-0.1", "1.1");
}

}  // namespace hm::corpus
