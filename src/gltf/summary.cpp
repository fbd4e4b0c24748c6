#include "gltf/summary.h"

#include <set>

#include "base/files.h"
#include "gltf/asset.h"
#include "gltf/container.h"
#include "gltf/document.h"

namespace hm {
namespace {

Result<std::string> text_of(const Json& json, std::string_view key) {
    HM_TRY_ASSIGN(const auto text, json.text(key));
    return std::string(text.value_or(""));
}

Result<void> read_asset(const Json& root, FileSummary& summary) {
    HM_TRY_ASSIGN(const auto asset, root.object("asset"));
    if (!asset) return {};
    HM_TRY_ASSIGN(summary.version, text_of(*asset, "version"));
    HM_TRY_ASSIGN(summary.min_version, text_of(*asset, "minVersion"));
    HM_TRY_ASSIGN(summary.generator, text_of(*asset, "generator"));
    HM_TRY_ASSIGN(summary.copyright, text_of(*asset, "copyright"));
    return {};
}

Result<std::vector<FileExtension>> read_extensions(const Json& root) {
    HM_TRY_ASSIGN(std::vector<std::string_view> names, root.texts("extensionsUsed"));
    HM_TRY_ASSIGN(const std::vector<std::string_view> demanded, root.texts("extensionsRequired"));
    // Required extensions must be listed as used as well, but not every file does so.
    names.insert(names.end(), demanded.begin(), demanded.end());
    const std::set<std::string_view> required(demanded.begin(), demanded.end());
    std::set<std::string_view> known;  // a set, since malicious lists are long
    std::vector<FileExtension> extensions;
    for (const std::string_view name : names)
        if (known.insert(name).second)
            extensions.push_back(
                {std::string(name), required.contains(name), gltf::is_supported(name)});
    return extensions;
}

Result<std::vector<std::string>> names_of(const std::vector<Json>& items) {
    std::vector<std::string> names;
    for (const Json& item : items) {
        HM_TRY_ASSIGN(names.emplace_back(), gltf::name_of(item));
    }
    return names;
}

Result<void> count_tables(const Json& root, FileCounts& counts) {
    const std::pair<const char*, std::size_t*> tables[] = {
        {"scenes", &counts.scenes},     {"nodes", &counts.nodes},
        {"meshes", &counts.meshes},     {"materials", &counts.materials},
        {"textures", &counts.textures}, {"images", &counts.images},
        {"cameras", &counts.cameras},   {"animations", &counts.animations},
        {"skins", &counts.skins},       {"accessors", &counts.accessors},
        {"buffers", &counts.buffers},   {"bufferViews", &counts.buffer_views},
    };
    for (const auto& [name, count] : tables) {
        HM_TRY_ASSIGN(const std::vector<Json> items, root.objects(name));
        *count = items.size();
    }
    HM_TRY_ASSIGN(const auto punctual, gltf::extension_of(root, "KHR_lights_punctual"));
    if (punctual) {
        HM_TRY_ASSIGN(const std::vector<Json> lights, punctual->objects("lights"));
        counts.lights = lights.size();
    }
    return {};
}

}  // namespace

Result<FileSummary> read_summary(const std::filesystem::path& path) {
    const std::string file = path.string();
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(path));
    Diagnostics ignored;  // load_gltf reports them
    HM_TRY_ASSIGN(const gltf::Container container, gltf::split_container(bytes, file, ignored));
    HM_TRY_ASSIGN(const JsonDocument document, gltf::parse_document(container.json, file));
    const Json& root = document.root();

    FileSummary summary;
    summary.bytes = bytes.size();
    summary.binary = container.json.data() != bytes.data();
    HM_TRY(read_asset(root, summary));
    HM_TRY_ASSIGN(summary.extensions, read_extensions(root));
    HM_TRY(count_tables(root, summary.counts));
    HM_TRY_ASSIGN(const std::vector<Json> scenes, root.objects("scenes"));
    HM_TRY_ASSIGN(summary.scenes, names_of(scenes));
    HM_TRY_ASSIGN(const auto chosen, root.index("scene", scenes.size(), "scenes"));
    summary.scene = chosen.value_or(0);
    HM_TRY_ASSIGN(const auto extension, gltf::extension_of(root, "KHR_materials_variants"));
    if (extension) {
        HM_TRY_ASSIGN(const std::vector<Json> variants, extension->objects("variants"));
        HM_TRY_ASSIGN(summary.variants, names_of(variants));
    }
    return summary;
}

}  // namespace hm
