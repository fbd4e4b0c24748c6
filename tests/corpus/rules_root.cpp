// The root object, its asset property and the declared extensions (glTF 2.0, 3.2, 3.12, 5.9, 5.17).
#include <fmt/format.h>

#include "corpus/reasons.h"
#include "corpus/rules.h"

namespace hm::corpus {
namespace {

void add_asset_rules(std::vector<Case>& cases) {
    Object asset(cases, "asset", "5.9", "/asset");
    asset.rule("missing", "asset: is required", {drop("/asset")}, refused("/asset", "is required"));
    asset.rule("type", "asset: is an object", {set("/asset", "[]")},
               refused("/asset", "expected an object, found an array"));
    asset.required("version");
    asset.text("version");
    for (const char* version : {"", "2", "2.", ".0", "two", "2.0.1", " 2.0", "2.0 ", "-2.0"})
        asset.value("version", fmt::format("pattern-{}", cases.size()),
                    fmt::format("\"{}\"", version),
                    fmt::format("matches ^[0-9]+\\.[0-9]+$ (\"{}\" does not)", version),
                    "is not a version");
    asset.text("minVersion");
    asset.value("minVersion", "pattern", R"("2.x")", "matches ^[0-9]+\\.[0-9]+$",
                "is not a version");
    asset.rule("minVersion-above", "minVersion: is not greater than version",
               {set("/asset/minVersion", R"("2.1")")},
               refused("/asset/minVersion", "requires glTF 2.1", ErrorKind::unsupported));
    asset.rule("version-1", "version: the file is glTF 2", {set("/asset/version", R"("1.0")")},
               refused("/asset/version", "only 2.x", ErrorKind::unsupported));
    asset.rule("version-3", "version: the file is glTF 2", {set("/asset/version", R"("3.0")")},
               refused("/asset/version", "only 2.x", ErrorKind::unsupported));
    asset.text("generator");
    asset.text("copyright");
    asset.common(false);
}

void add_extension_lists(std::vector<Case>& cases) {
    Object root(cases, "root", "3.12", "");
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        root.value(list, "type", R"("KHR_a")", "is an array", "expected an array, found a string");
        root.rule(fmt::format("{}-element-type", list),
                  fmt::format("{}: elements are strings", list),
                  {set(fmt::format("/{}", list), "[1]")},
                  refused(fmt::format("/{}/0", list), "expected a string, found a number"));
        root.value(list, "empty", "[]", "has at least one element", "")
            .expect(ignored(kEmptyIsNone));
    }
    root.value("extensionsUsed", "repeated",
               R"(["KHR_lights_punctual","KHR_materials_emissive_strength","KHR_materials_unlit",
                   "KHR_texture_transform","KHR_materials_unlit"])",
               "has no element twice", "")
        .expect(ignored(kUnread));
    root.value("extensionsRequired", "repeated", R"(["KHR_materials_unlit","KHR_materials_unlit"])",
               "has no element twice", "")
        .expect(ignored(kUnread));
    root.rule("extensionsRequired-unused", "extensionsRequired: all are in extensionsUsed",
              {set("/extensionsUsed", R"(["KHR_lights_punctual","KHR_materials_emissive_strength",
                   "KHR_texture_transform"])"),
               set("/extensionsRequired", R"(["KHR_materials_unlit"])")},
              ignored(kUnread));
    root.rule("extensionsUsed-undeclared", "extensionsUsed: names all extensions in the file",
              {drop("/extensionsUsed")}, ignored(kUnread));
    root.rule("extensionsRequired-unknown", "extensionsRequired: a renderer has them all",
              {set("/extensionsUsed/4", R"("EXT_unknown")"),
               set("/extensionsRequired", R"(["EXT_unknown"])")},
              refused("/extensionsRequired", "EXT_unknown", ErrorKind::unsupported))
        .silent("what a renderer supports is not the validator's business");
}

}  // namespace

void add_root_rules(std::vector<Case>& cases) {
    add_asset_rules(cases);
    add_extension_lists(cases);
    Object root(cases, "root", "5.17", "");
    Object empty(cases, "root", "5.17", "", Base::minimal);
    for (const char* table : {"accessors", "buffers", "bufferViews", "cameras", "images",
                              "materials", "meshes", "nodes", "samplers", "scenes", "textures"}) {
        root.objects(table);
        empty.empty(table).expect(ignored(kEmptyIsNone));
    }
    for (const char* table : {"animations", "skins"})
        root.objects(table);
    root.index("scene");
    root.value("extensions", "type", "[]", "is an object", "expected an object, found an array");
}

}  // namespace hm::corpus
