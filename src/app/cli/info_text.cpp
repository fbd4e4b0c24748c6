// The report as text. Every line goes through printable(), so that names can't contain escape
// sequences or line breaks.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "app/cli/info_report.h"
#include "base/text.h"
#include "scene/material_parameters.h"
#include "scene/pose.h"

namespace hm::cli {
namespace {

constexpr std::size_t kLongestList = 100;  // lines of one section; --json has no limit
constexpr std::size_t kLongestName = 80;   // bytes
constexpr std::size_t kDeepestIndent = 30;

std::string cut(std::string_view text) {
    if (text.size() <= kLongestName) return std::string(text);
    std::size_t end = kLongestName;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u)
        --end;  // within a character
    return std::string(text.substr(0, end)) + "...";
}

std::string name_in_quotes(std::string_view name) {
    return name.empty() ? "" : fmt::format(" \"{}\"", cut(name));
}

std::string size_text(std::uint64_t bytes) {
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", double(bytes) / 1024);
    return fmt::format("{:.1f} MiB", double(bytes) / (1024 * 1024));
}

std::string plural_of(std::uint64_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string plural(std::uint64_t count, std::string_view what) {
    return plural_of(count, what, fmt::format("{}s", what));
}

// The lines of a section, of which only the first ones are shown.
class Lines {
  public:
    void line(std::string_view text) { text_ += printable(text) + "\n"; }

    template <class Items, class Describe>
    void section(std::string_view title, const Items& items, Describe describe) {
        if (items.empty()) return;
        line("");
        line(fmt::format("{} ({})", title, items.size()));
        for (std::size_t i = 0; i < std::min(items.size(), kLongestList); ++i)
            line("  " + describe(i, items[i]));
        if (items.size() > kLongestList)
            line(fmt::format("  ... and {} more; --json lists all", items.size() - kLongestList));
    }

    std::string text() && { return std::move(text_); }

  private:
    std::string text_;
};

// Two points, in the file's coordinates, with digits that resolve a ten-thousandth of their
// distance.
std::string bounds_text(const Bounds& bounds, const glm::dvec3& origin) {
    const glm::dvec3 low = origin + glm::dvec3(bounds.low);
    const glm::dvec3 high = origin + glm::dvec3(bounds.high);
    const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
    const double largest = std::max({farthest.x, farthest.y, farthest.z});
    const double ratio = std::min(largest / glm::length(high - low), 1e12);
    const int digits = ratio > 1 ? std::clamp(5 + int(std::log10(ratio)), 6, 17) : 6;
    return fmt::format("from {:.{}g} {:.{}g} {:.{}g} to {:.{}g} {:.{}g} {:.{}g} metres", low.x,
                       digits, low.y, digits, low.z, digits, high.x, digits, high.y, digits, high.z,
                       digits);
}

std::string vector_text(vec3 v) {
    return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z);
}

void describe_file(Lines& out, const InfoReport& report) {
    const FileSummary& f = *report.file;
    out.line(report.input);
    out.line(fmt::format("  glTF {}, {}, {}", cut(f.version), f.binary ? "binary" : "text",
                         size_text(f.bytes)));
    if (!f.generator.empty()) out.line("  generator: " + cut(f.generator));
    if (!f.copyright.empty()) out.line("  copyright: " + cut(f.copyright));
    if (!f.scenes.empty())
        out.line(fmt::format("  scene {} of {}{}", f.scene, f.scenes.size(),
                             name_in_quotes(f.scenes[f.scene])));
    out.section("Extensions", f.extensions, [](std::size_t, const FileExtension& e) {
        return fmt::format("{}, {}: {}", cut(e.name), e.required ? "required" : "used",
                           treatment(e));
    });
}

void describe_totals(Lines& out, const InfoReport& report) {
    const InfoTotals t = totals(report);
    const FileCounts& in_file = report.file->counts;
    const Bounds& bounds = report.flat->bounds;
    out.line("");
    out.line("Drawn");
    if (bounds.empty()) {
        out.line("  nothing");
    } else {
        out.line("  " + bounds_text(bounds, report.scene->origin));
    }
    out.line(fmt::format("  {} in {} of {}", plural(t.drawn_triangles, "triangle"),
                         plural(t.instances, "instance"),
                         plural_of(report.scene->meshes.size(), "mesh", "meshes")));
    out.line(fmt::format("  each mesh once: {}, {}, {}", plural(t.triangles, "triangle"),
                         plural_of(t.vertices, "vertex", "vertices"), size_text(t.geometry_bytes)));
    if (t.emissive_triangles > 0)
        out.line(fmt::format("  {} give light", plural(t.emissive_triangles, "triangle")));
    out.line(fmt::format("  {} of {}, {} decoded", report.scene->images.size(),
                         plural(in_file.images, "image"), size_text(t.image_bytes)));
}

std::string node_text(const Scene& scene, const Node& node) {
    std::string text = node.name.empty() ? "(no name)" : cut(node.name);
    const auto add = [&](std::string_view what, int index, std::string_view name) {
        if (index != kUnset) text += fmt::format(" [{} {}{}]", what, index, name_in_quotes(name));
    };
    const auto at = [](const auto& items, int index) {
        return index == kUnset ? std::string() : items[std::size_t(index)].name;
    };
    add("mesh", node.mesh, at(scene.meshes, node.mesh));
    add("skin", node.skin, at(scene.skins, node.skin));
    add("camera", node.camera, at(scene.cameras, node.camera));
    add("light", node.light, at(scene.lights, node.light));
    if (!node.instances.empty()) text += fmt::format(" x {}", node.instances.size());
    if (!node.visible) text += " (hidden, with all below it)";
    return text;
}

void describe_nodes(Lines& out, const Scene& scene) {
    std::vector<std::size_t> depth(scene.nodes.size(), 0);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        if (const int parent = scene.nodes[i].parent; parent != kUnset)
            depth[i] = depth[std::size_t(parent)] + 1;
    out.section("Nodes", scene.nodes, [&](std::size_t i, const Node& node) {
        return std::string(2 * std::min(depth[i], kDeepestIndent), ' ') + node_text(scene, node);
    });
}

void describe_meshes(Lines& out, const InfoReport& report) {
    const std::vector<std::uint64_t> uses = mesh_uses(report);
    out.section("Meshes", report.scene->meshes, [&](std::size_t i, const Mesh& mesh) {
        std::string text =
            fmt::format("{}{}: {}, {} in {}, shown {}", i, name_in_quotes(mesh.name),
                        plural_of(vertex_count(mesh), "vertex", "vertices"),
                        plural(triangle_count(mesh), "triangle"),
                        plural(mesh.primitives.size(), "primitive"), plural(uses[i], "time"));
        if (target_count(mesh) > 0) text += ", " + plural(target_count(mesh), "morph target");
        return text;
    });
}

// The metallic-roughness model's factors, and others that differ from their defaults. Unlit
// materials only have a colour.
bool is_shown(const MaterialFactor& factor, std::span<const float> numbers, bool unlit) {
    if (unlit) return factor.value == AnimatedValue::base_color;
    return factor.owner == "pbrMetallicRoughness" ||
           std::any_of(numbers.begin(), numbers.end(), [&](float x) { return x != factor.start; });
}

// ", base color 1 0.5 0.5 1"
std::string factor_text(const MaterialFactor& factor, std::span<const float> numbers) {
    std::string text(factor.name);
    std::replace(text.begin(), text.end(), '_', ' ');
    return fmt::format(", {} {:g}", text, fmt::join(numbers, " "));
}

void describe_materials(Lines& out, const Scene& scene) {
    out.section("Materials", scene.materials, [](std::size_t i, const Material& m) {
        std::string text =
            fmt::format("{}{}: {}", i, name_in_quotes(m.name), alpha_mode_name(m.alpha_mode));
        if (m.double_sided) text += ", double sided";
        if (m.unlit) text += ", unlit";
        for (const MaterialFactor& factor : material_factors()) {
            const std::span<const float> numbers = material_floats(m, factor.value);
            if (is_shown(factor, numbers, m.unlit)) text += factor_text(factor, numbers);
        }
        for (const NamedSlot& used : used_slots(m))
            text += fmt::format(", {} image {}", used.role, used.slot->image);
        return text;
    });
}

void describe_images(Lines& out, const Scene& scene) {
    const auto roles = image_roles(scene);
    out.section("Images", scene.images, [&](std::size_t i, const TextureImage& image) {
        std::string text =
            fmt::format("{}: {} x {} {}, {}:", i, image.width(), image.height(),
                        format_name(image.format()), size_text(image.bytes().size()));
        for (std::size_t k = 0; k < roles[i].size(); ++k)
            text.append(k == 0 ? " " : ", ").append(roles[i][k]);
        return text;
    });
}

void describe_lights_and_cameras(Lines& out, const Scene& scene) {
    const auto degrees = [](float radians) { return radians * 180 / std::numbers::pi_v<float>; };
    out.section("Lights", scene.lights, [&](std::size_t i, const Light& light) {
        std::string text =
            fmt::format("{}{}: {}, color {}, {:g} {}", i, name_in_quotes(light.name),
                        light_kind_name(light.kind), vector_text(light.color), light.intensity,
                        light.kind == kLightDirectional ? "lux" : "candela");
        if (light.range > 0) text += fmt::format(", range {:g} m", light.range);
        if (light.kind == kLightSpot)
            text += fmt::format(", cone {:g} to {:g} degrees", degrees(light.inner_cone),
                                degrees(light.outer_cone));
        return text;
    });
    out.section("Cameras", scene.cameras, [&](std::size_t i, const Camera& camera) {
        std::string text = fmt::format("{}{}: ", i, name_in_quotes(camera.name));
        if (camera.fault) return text + "unusable, see the warnings";
        if (camera.perspective)
            return text + fmt::format("perspective, {:g} degrees high", degrees(camera.yfov));
        return text + fmt::format("orthographic, {:g} x {:g} m", 2 * camera.xmag, 2 * camera.ymag);
    });
}

void describe_motion(Lines& out, const InfoReport& report) {
    const Scene& scene = *report.scene;
    out.section("Animations", scene.animations, [](std::size_t i, const Animation& animation) {
        return fmt::format("{}{}: {:g} s, {}", i, name_in_quotes(animation.name),
                           duration(animation), plural(channel_count(animation), "channel"));
    });
    if (scene.animations.size() > 1)
        out.line(fmt::format("  --animation all plays them together; {} set by more than one",
                             plural_of(count_shared_targets(scene), "property", "properties")));
    out.section("Skins", scene.skins, [](std::size_t i, const Skin& skin) {
        return fmt::format("{}{}: {}", i, name_in_quotes(skin.name),
                           plural(skin.joints.size(), "joint"));
    });
    out.section("Variants", report.file->variants, [](std::size_t i, const std::string& name) {
        return fmt::format("{}{}", i, name_in_quotes(name));
    });
}

}  // namespace

std::string info_text(const InfoReport& report) {
    Lines out;
    describe_file(out, report);
    if (report.flat) {
        describe_totals(out, report);
        describe_nodes(out, *report.scene);
        describe_meshes(out, report);
        describe_materials(out, *report.scene);
        describe_images(out, *report.scene);
        describe_lights_and_cameras(out, *report.scene);
        describe_motion(out, report);
    }
    out.section("Notes", report.diagnostics.notes(), [](std::size_t, const Warning& note) {
        return Warning{"", note.location, note.message, note.count}.line();
    });
    out.section("Warnings", report.diagnostics.warnings(), [](std::size_t, const Warning& warning) {
        return Warning{"", warning.location, warning.message, warning.count}.line();
    });
    return std::move(out).text();
}

}  // namespace hm::cli
