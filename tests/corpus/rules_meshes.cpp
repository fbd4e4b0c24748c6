// Meshes and primitives: topology, attributes and their types (glTF 2.0, 3.7.2, 5.23, 5.24).
#include <fmt/format.h>

#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

constexpr char kPlace[] = "/meshes/0/primitives/0/attributes/";

void add_attribute_types(std::vector<Case>& cases) {
    Object attributes(cases, "attributes", "3.7.2.1", "/meshes/0/primitives/0/attributes");
    const auto mistyped = [&](const char* name, const char* slug, int accessor) {
        attributes.rule(
            fmt::format("{}-{}", name, slug), fmt::format("{}: has one of its allowed types", name),
            {set(kPlace + std::string(name), std::to_string(accessor))},
            refused(kPlace + std::string(name), "a type that is invalid for this attribute"));
    };
    mistyped("POSITION", "vec2", 2);
    mistyped("POSITION", "vec4", 5);
    mistyped("POSITION", "bytes", 4);
    mistyped("NORMAL", "vec2", 2);
    mistyped("NORMAL", "scalar", 3);
    mistyped("TANGENT", "vec3", 1);
    mistyped("TANGENT", "bytes", 4);
    mistyped("TEXCOORD_0", "vec3", 1);
    mistyped("TEXCOORD_0", "scalar", 3);
    mistyped("COLOR_0", "vec2", 2);
    mistyped("COLOR_0", "scalar", 3);
    attributes.rule(
        "COLOR_0-not-normalized", "COLOR_0: integers are normalized",
        {drop("/accessors/4/normalized")},
        refused(kPlace + std::string("COLOR_0"), "a type that is invalid for this attribute"));
    attributes.rule(
        "TEXCOORD_0-signed", "TEXCOORD_0: not signed integers",
        {set("/accessors/2/componentType", "5122"), set("/accessors/2/normalized", "true"),
         set("/bufferViews/2/byteStride", "8")},
        refused(kPlace + std::string("TEXCOORD_0"), "a type that is invalid for this attribute"));
    for (const char* name : {"NORMAL", "TEXCOORD_0", "COLOR_0", "TANGENT"})
        attributes.rule(fmt::format("{}-count", name),
                        fmt::format("{}: as many elements as POSITION", name),
                        {set(fmt::format("/accessors/{}/count", name[0] == 'N'   ? 1
                                                                : name[0] == 'C' ? 4
                                                                : name[1] == 'E' ? 2
                                                                                 : 5),
                             "2")},
                        refused(kPlace + std::string(name), "has 2 elements, POSITION has 3"));
}

void add_indices(std::vector<Case>& cases) {
    Object primitive(cases, "indices", "3.7.2.1", "/meshes/0/primitives/0");
    const auto refuse = [&](const char* slug, const char* rule, Edits edits) {
        primitive.rule(
            slug, rule, std::move(edits),
            refused("/meshes/0/primitives/0/indices", "indices must be unsigned integer scalars"));
    };
    refuse("float", "indices: unsigned integers",
           {set("/accessors/3/componentType", "5126"), set("/accessors/3/count", "1")});
    refuse("signed", "indices: unsigned integers", {set("/accessors/3/componentType", "5122")});
    refuse("vector", "indices: scalars",
           {set("/accessors/3/type", R"("VEC3")"), set("/accessors/3/count", "1")});
    refuse("normalized", "indices: not normalized", {set("/accessors/3/normalized", "true")});
    primitive
        .rule("count-2", "indices: as many as the mode needs", {set("/accessors/3/count", "2")},
              warned("/meshes/0/primitives/0", "do not complete a triangle", kSkipped))
        .silent(kOnlyWarns);
    primitive
        .rule("count-strip", "indices: as many as the mode needs",
              {set("/accessors/3/count", "2"), set("/meshes/0/primitives/0/mode", "5")},
              warned("/meshes/0/primitives/0", "do not complete a triangle", kSkipped))
        .silent(kOnlyWarns);
}

}  // namespace

void add_mesh_rules(std::vector<Case>& cases) {
    Object mesh(cases, "mesh", "5.23", "/meshes/0");
    mesh.required("primitives").expect(warned("/meshes/0", "the mesh has no primitives", kSkipped));
    mesh.objects("primitives");
    mesh.empty("primitives").expect(warned("/meshes/0", "the mesh has no primitives", kSkipped));
    mesh.common();

    Object primitive(cases, "primitive", "5.24", "/meshes/0/primitives/0");
    primitive.required("attributes");
    primitive.object("attributes");
    primitive.value("attributes", "empty", "{}", "has at least one property", "")
        .expect(warned("/meshes/0/primitives/0", "without POSITION is ignored", kSkipped));
    primitive
        .rule("positions-missing", "attributes: POSITION should be there",
              {drop(kPlace + std::string("POSITION"))},
              warned("/meshes/0/primitives/0", "without POSITION is ignored", kSkipped))
        .silent(kOnlyWarns);
    primitive.index("indices");
    primitive.index("material");
    primitive.integer("mode");
    primitive.value("mode", "unknown", "7", "is at most 6", "7 is not a mode");
    primitive.extensions();
    primitive.rule("texcoord-missing", "material: its textures find their coordinates",
                   {drop(kPlace + std::string("TEXCOORD_0"))},
                   warned("/meshes/0/primitives/0",
                          "texture coordinates that the material uses are missing", kRepaired));

    Object attributes(cases, "attributes", "3.7.2.1", "/meshes/0/primitives/0/attributes");
    for (const char* name : {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0", "COLOR_0"})
        attributes.index(name);
    const auto unknown = [&](const char* name, const char* rule) {
        return attributes.rule(name, rule, {set(kPlace + std::string(name), "2")},
                               ignored(kUnread));
    };
    unknown("TEXCOORD_2", "TEXCOORD: sets are numbered without gaps");
    unknown("TEXCOORD_01", "TEXCOORD: set numbers have no leading zeros");
    unknown("TEXCOORD", "TEXCOORD: has a set number");
    unknown("UNKNOWN", "names: known ones, or with an underscore first");
    unknown("_lower", "names: application-specific ones are in capitals").silent(kProseOnly);
    attributes.rule("unread-past-end", "indices of accessors that exist",
                    {set(kPlace + std::string("_OTHER"), "99")},
                    refused(kPlace + std::string("_OTHER"), "past the end of the 7 accessors"));
    attributes.rule("stride-unaligned", "offsets and strides of vertex data: multiples of 4",
                    {set("/accessors/4/type", R"("VEC3")"), set("/accessors/4/count", "3")},
                    warned("/accessors/4", "not aligned to 4 bytes", kDecodable));
    add_attribute_types(cases);
    add_indices(cases);
}

}  // namespace hm::corpus
