#include "app/cli/info_report.h"

#include <algorithm>
#include <charconv>

#include "app/cli/hints.h"
#include "gltf/load.h"
#include "scene/choice_names.h"
#include "scene/material_parameters.h"

namespace hm::cli {
namespace {

// The scene that was loaded instead of the file's default: a name wins over an index.
std::size_t find_scene(const std::vector<std::string>& names, const std::string& wanted) {
    const auto named = std::find(names.begin(), names.end(), wanted);
    if (named != names.end()) return std::size_t(named - names.begin());
    std::size_t index = 0;
    std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    return index;
}

}  // namespace

InfoReport examine(const InfoOptions& options) {
    InfoReport report;
    report.input = options.input;
    report.scene_file = options.scene_file.string();
    Result<FileSummary> file = read_summary(options.scene_file);
    if (file) report.file = std::move(*file);
    Result<Scene> scene = load_gltf(options.scene_file, report.diagnostics, options.load);
    if (scene) {
        report.scene = std::move(*scene);
        if (report.file && !options.load.scene.empty())
            report.file->scene = find_scene(report.file->scenes, options.load.scene);
        report.flat = flatten(*report.scene, {}, {}, report.diagnostics);
    } else {
        report.error = with_hint(std::move(scene.error()));
    }
    return report;
}

std::uint64_t triangle_count(const Mesh& mesh) {
    std::uint64_t count = 0;
    for (const Primitive& primitive : mesh.primitives)
        count += primitive.triangles.size();
    return count;
}

std::uint64_t vertex_count(const Mesh& mesh) {
    std::uint64_t count = 0;
    for (const Primitive& primitive : mesh.primitives)
        count += primitive.vertices.size();
    return count;
}

std::size_t target_count(const Mesh& mesh) {
    return mesh.weights.size();
}

std::size_t channel_count(const Animation& animation) {
    return animation.channels.size() + animation.values.size();
}

double duration(const Animation& animation) {
    float last = 0;
    for (const AnimationSampler& sampler : animation.samplers)
        if (!sampler.times.empty()) last = std::max(last, sampler.times.back());
    return double(last);
}

std::vector<std::uint64_t> mesh_uses(const InfoReport& report) {
    std::vector<std::uint64_t> uses(report.scene->meshes.size(), 0);
    for (const InstanceData& instance : report.flat->instances)
        ++uses[instance.mesh];
    return uses;
}

InfoTotals totals(const InfoReport& report) {
    InfoTotals t;
    const std::vector<std::uint64_t> uses = mesh_uses(report);
    for (std::size_t m = 0; m < uses.size(); ++m) {
        const Mesh& mesh = report.scene->meshes[m];
        t.primitives += mesh.primitives.size();
        t.vertices += vertex_count(mesh);
        t.triangles += triangle_count(mesh);
        t.drawn_triangles += uses[m] * triangle_count(mesh);
        t.morph_targets += target_count(mesh);
        for (const Primitive& p : mesh.primitives)
            t.geometry_bytes += p.vertices.size() * sizeof(Vertex) +
                                p.extras.size() * sizeof(VertexExtra) +
                                p.triangles.size() * sizeof(uvec3);
    }
    t.instances = report.flat->instances.size();
    t.emissive_triangles = report.flat->emitters.size();
    for (const TextureImage& image : report.scene->images)
        t.image_bytes += image.bytes().size();
    return t;
}

std::vector<NamedSlot> used_slots(const Material& m) {
    std::vector<NamedSlot> used;
    for (const MaterialTexture& texture : material_textures()) {
        const TextureSlot& slot = m.*texture.slot;
        constexpr std::string_view kTexture = "Texture";
        const std::string_view role = texture.key.substr(0, texture.key.size() - kTexture.size());
        if (slot.image != kUnset) used.push_back({role, &slot});
    }
    return used;
}

std::vector<std::vector<std::string_view>> image_roles(const Scene& scene) {
    std::vector<std::vector<std::string_view>> roles(scene.images.size());
    for (const Material& material : scene.materials)
        for (const NamedSlot& named : used_slots(material)) {
            auto& known = roles[std::size_t(named.slot->image)];
            if (std::find(known.begin(), known.end(), named.role) == known.end())
                known.push_back(named.role);
        }
    return roles;
}

std::string_view treatment(const FileExtension& extension) {
    return extension.supported ? "supported" : extension.required ? "refused" : "ignored";
}

std::string_view alpha_mode_name(std::uint32_t mode) {
    return kAlphaModeNames.at(mode);
}

std::string_view light_kind_name(std::uint32_t kind) {
    return kLightKindNames.at(kind);
}

std::string_view format_name(PixelFormat format) {
    return format == PixelFormat::rgba8 ? "rgba8" : "rgba16";
}

}  // namespace hm::cli
