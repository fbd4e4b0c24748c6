// The report as JSON; docs/info-schema.md and docs/info.schema.json describe it.
#include <algorithm>
#include <span>

#include "app/cli/info_report.h"
#include "base/json_writer.h"
#include "scene/material_parameters.h"

namespace hm::cli {
namespace {

// Incremented when a field changes its meaning or is removed; not for new fields.
constexpr std::uint32_t kSchema = 1;

void write_index(JsonWriter& json, std::string_view key, int index) {
    json.key(key);
    if (index == kUnset) {
        json.null();
    } else {
        json.value(unsigned(index));
    }
}

template <class Numbers>
void write_numbers(JsonWriter& json, std::string_view key, const Numbers& numbers,
                   std::size_t count) {
    json.key(key).begin_array();
    for (std::size_t i = 0; i < count; ++i)
        json.value(double(numbers[i]));
    json.end_array();
}

template <class Items, class Write>
void write_list(JsonWriter& json, std::string_view key, const Items& items, Write write) {
    json.key(key).begin_array();
    for (std::size_t i = 0; i < items.size(); ++i) {
        json.begin_object();
        write(i, items[i]);
        json.end_object();
    }
    json.end_array();
}

void write_counts(JsonWriter& json, const FileCounts& c) {
    json.key("counts").begin_object();
    json.field("scenes", c.scenes).field("nodes", c.nodes).field("meshes", c.meshes);
    json.field("materials", c.materials).field("textures", c.textures).field("images", c.images);
    json.field("cameras", c.cameras).field("lights", c.lights);
    json.field("animations", c.animations).field("skins", c.skins);
    json.field("accessors", c.accessors).field("buffer_views", c.buffer_views);
    json.field("buffers", c.buffers).end_object();
}

void write_file(JsonWriter& json, const std::optional<FileSummary>& file) {
    json.key("file");
    if (!file) {
        json.null();
        return;
    }
    json.begin_object();
    json.field("container", file->binary ? "glb" : "gltf").field("bytes", file->bytes);
    json.field("version", file->version).field("min_version", file->min_version);
    json.field("generator", file->generator).field("copyright", file->copyright);
    write_list(json, "extensions", file->extensions, [&](std::size_t, const FileExtension& e) {
        json.field("name", e.name).field("required", e.required).field("treatment", treatment(e));
    });
    write_counts(json, file->counts);
    json.key("scenes").values(file->scenes);
    json.field("scene", file->scene);
    json.key("variants").values(file->variants);
    json.end_object();
}

void write_totals(JsonWriter& json, const InfoReport& report) {
    const InfoTotals t = totals(report);
    json.key("totals").begin_object();
    json.field("primitives", t.primitives).field("instances", t.instances);
    json.field("triangles", t.triangles).field("drawn_triangles", t.drawn_triangles);
    json.field("vertices", t.vertices).field("emissive_triangles", t.emissive_triangles);
    json.field("morph_targets", t.morph_targets);
    json.field("geometry_bytes", t.geometry_bytes).field("image_bytes", t.image_bytes);
    json.end_object();
}

void write_bounds(JsonWriter& json, const Bounds& bounds, const glm::dvec3& origin) {
    json.key("bounds");
    if (bounds.empty()) {
        json.null();
        return;
    }
    json.begin_object();
    write_numbers(json, "min", origin + glm::dvec3(bounds.low), 3);
    write_numbers(json, "max", origin + glm::dvec3(bounds.high), 3);
    json.end_object();
}

void write_nodes(JsonWriter& json, const Scene& scene) {
    write_list(json, "nodes", scene.nodes, [&](std::size_t, const Node& node) {
        json.field("name", node.name);
        write_index(json, "file_index", node.index);
        write_index(json, "parent", node.parent);
        write_index(json, "mesh", node.mesh);
        write_index(json, "skin", node.skin);
        write_index(json, "camera", node.camera);
        write_index(json, "light", node.light);
        json.field("instances", std::max<std::size_t>(1, node.instances.size()));
        json.field("visible", node.visible);
    });
}

void write_meshes(JsonWriter& json, const InfoReport& report) {
    const std::vector<std::uint64_t> uses = mesh_uses(report);
    write_list(json, "meshes", report.scene->meshes, [&](std::size_t i, const Mesh& mesh) {
        json.field("name", mesh.name).field("instances", uses[i]);
        json.field("morph_targets", target_count(mesh));
        write_list(json, "primitives", mesh.primitives, [&](std::size_t, const Primitive& p) {
            json.field("triangles", p.triangles.size()).field("vertices", p.vertices.size());
            write_index(json, "material", p.material);
            json.field("normals", p.has_normals).field("tangents", p.has_tangents);
        });
    });
}

// Factors of extensions are written where they differ from their defaults.
void write_factor(JsonWriter& json, const MaterialFactor& factor, std::span<const float> numbers) {
    const auto is_default = [&](float number) { return number == factor.start; };
    if (factor.extended && std::all_of(numbers.begin(), numbers.end(), is_default)) return;
    if (factor.components == 1)
        json.field(factor.name, double(numbers[0]));
    else
        write_numbers(json, factor.name, numbers, factor.components);
}

void write_materials(JsonWriter& json, const Scene& scene) {
    write_list(json, "materials", scene.materials, [&](std::size_t, const Material& m) {
        json.field("name", m.name).field("alpha_mode", alpha_mode_name(m.alpha_mode));
        json.field("double_sided", m.double_sided).field("unlit", m.unlit);
        if (m.specular_glossiness) json.field("specular_glossiness", true);
        for (const MaterialFactor& factor : material_factors())
            write_factor(json, factor, material_floats(m, factor.value));
        write_numbers(json, "emissive", m.emissive(), 3);
        write_list(json, "textures", used_slots(m), [&](std::size_t, const NamedSlot& used) {
            json.field("role", used.role);
            write_index(json, "image", used.slot->image);
            json.field("uv_set", used.slot->uv_set);
        });
    });
}

void write_images(JsonWriter& json, const Scene& scene) {
    const auto roles = image_roles(scene);
    write_list(json, "images", scene.images, [&](std::size_t i, const TextureImage& image) {
        json.field("width", image.width()).field("height", image.height());
        json.field("format", format_name(image.format())).field("bytes", image.bytes().size());
        json.key("roles").values(roles[i]);
    });
}

void write_lights_and_cameras(JsonWriter& json, const Scene& scene) {
    write_list(json, "lights", scene.lights, [&](std::size_t, const Light& light) {
        json.field("name", light.name).field("kind", light_kind_name(light.kind));
        write_numbers(json, "color", light.color, 3);
        json.field("intensity", double(light.intensity)).field("range", double(light.range));
        json.field("inner_cone", double(light.inner_cone));
        json.field("outer_cone", double(light.outer_cone));
    });
    write_list(json, "cameras", scene.cameras, [&](std::size_t, const Camera& camera) {
        json.field("name", camera.name);
        json.field("kind", camera.perspective ? "perspective" : "orthographic");
        json.field("yfov", double(camera.yfov)).field("aspect_ratio", double(camera.aspect_ratio));
        json.field("xmag", double(camera.xmag)).field("ymag", double(camera.ymag));
        json.field("usable", !camera.fault);
    });
}

void write_motion(JsonWriter& json, const Scene& scene) {
    write_list(json, "animations", scene.animations, [&](std::size_t, const Animation& animation) {
        json.field("name", animation.name).field("seconds", duration(animation));
        json.field("channels", channel_count(animation));
    });
    write_list(json, "skins", scene.skins, [&](std::size_t, const Skin& skin) {
        json.field("name", skin.name).field("joints", skin.joints.size());
    });
}

void write_error(JsonWriter& json, const std::optional<Error>& error) {
    json.key("error");
    if (!error) {
        json.null();
        return;
    }
    json.begin_object().field("code", unsigned(exit_code(error->kind))).field("file", error->file);
    json.field("place", error->location).field("message", error->message).end_object();
}

std::string_view outcome(const InfoReport& report) {
    if (report.error) return "refused";
    return report.diagnostics.warnings().empty() ? "clean" : "warnings";
}

}  // namespace

std::string info_json(const InfoReport& report) {
    JsonWriter json;
    json.begin_object();
    json.field("schema", kSchema).field("program", "himalaya " HIMALAYA_VERSION);
    json.field("input", report.input).field("scene_file", report.scene_file);
    json.field("result", outcome(report));
    write_error(json, report.error);
    const auto write_warning = [&](std::size_t, const Warning& w) {
        json.field("file", w.file).field("place", w.location).field("message", w.message);
        json.field("count", w.count);
    };
    write_list(json, "warnings", report.diagnostics.warnings(), write_warning);
    write_list(json, "notes", report.diagnostics.notes(), write_warning);
    write_file(json, report.file);
    json.key("scene");
    if (report.flat) {
        json.begin_object();
        write_bounds(json, report.flat->bounds, report.scene->origin);
        write_totals(json, report);
        write_nodes(json, *report.scene);
        write_meshes(json, report);
        write_materials(json, *report.scene);
        write_images(json, *report.scene);
        write_lights_and_cameras(json, *report.scene);
        write_motion(json, *report.scene);
        json.end_object();
    } else {
        json.null();
    }
    json.end_object();
    return json.text() + "\n";
}

}  // namespace hm::cli
