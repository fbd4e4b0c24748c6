#include "scene/emitters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/alias_table.h"
#include "shading/shading.h"

namespace hm {
namespace {

// Runs the shared texture and emission code on the flat scene's tables.
struct EmissionReader {
    const FlatScene& flat;
    const TextureUse* texture_uses;
    const float* srgb = srgb_table();

    explicit EmissionReader(const FlatScene& scene)
        : flat(scene), texture_uses(scene.texture_uses.data()) {}

    uvec2 image_size(uint image) const {
        return {flat.images[image].width, flat.images[image].height};
    }
    vec4 fetch_texel(uint image, uint x, uint y, uint encoding) const {
        return fetch_image_texel(flat.images[image], x, y, encoding == kEncodingSrgb, srgb);
    }
#include "shading/texture/lookup.h"

    // Mean luminance over the triangle. The sampling grid matches the texel density, up to a limit:
    // an estimate is enough, as it only guides importance sampling.
    float mean(const MaterialData& m, const GeometryView& view, std::uint32_t primitive) {
        bool unlit = (m.flags & kMaterialUnlit) != 0;
        uint slot = unlit ? m.base_color_texture : m.emissive_texture;
        float factor = luminance(unlit ? vec3(m.base_color_factor) : m.emissive_factor);
        const TextureUse& use = texture_uses[slot];
        if (use.image == kImageWhite) return factor;
        uvec3 t = view.triangles[primitive];
        vec2 uv[3];
        for (int k = 0; k < 3; ++k)
            uv[k] = use.uv_set == 0 || !view.extras ? view.vertices[t[std::size_t(k)]].uv0
                                                    : view.extras[t[std::size_t(k)]].uv1;
        vec2 size(float(flat.images[use.image].width), float(flat.images[use.image].height));
        float texels = std::max(length((uv[1] - uv[0]) * size), length((uv[2] - uv[0]) * size));
        int steps = int(std::clamp(texels, 1.0f, 24.0f));
        vec3 sum(0);
        int count = 0;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                vec2 b = sample_triangle((float(i) + 0.5f) / float(steps),
                                         (float(j) + 0.5f) / float(steps));
                vec2 at = uv[0] * (1 - b.x - b.y) + uv[1] * b.x + uv[2] * b.y;
                sum += vec3(sample_texture(slot, kEncodingSrgb, at, at));
                ++count;
            }
        vec3 color = unlit ? vec3(m.base_color_factor) : m.emissive_factor;
        return luminance(color * sum / float(count));
    }
};

bool emits(const MaterialData& m) {
    if ((m.flags & kMaterialUnlit) != 0) return max_component(vec3(m.base_color_factor)) > 0;
    return max_component(m.emissive_factor) > 0;
}

// Emitters of a mesh are numbered consecutively across its emissive geometries.
std::uint32_t number_mesh_emitters(FlatScene& flat, std::size_t mesh) {
    std::uint32_t count = 0;
    for (std::uint32_t g = flat.mesh_first_geometry[mesh]; g < flat.mesh_first_geometry[mesh + 1];
         ++g) {
        GeometryData& geometry = flat.geometries[g];
        if (!emits(flat.materials[geometry.material])) continue;
        geometry.emitter_offset = count;
        count += geometry.triangle_count;
    }
    return count;
}

}  // namespace

void add_emitters(FlatScene& flat) {
    for (std::size_t mesh = 0; mesh + 1 < flat.mesh_first_geometry.size(); ++mesh)
        number_mesh_emitters(flat, mesh);
    EmissionReader reader(flat);
    std::vector<float> powers;
    for (std::uint32_t i = 0; i < flat.instances.size(); ++i) {
        InstanceData& instance = flat.instances[i];
        instance.first_emitter = std::uint32_t(flat.emitters.size());
        for (std::uint32_t g = instance.first_geometry;
             g < flat.mesh_first_geometry[instance.mesh + 1]; ++g) {
            if (flat.geometries[g].emitter_offset == kNone) continue;
            const GeometryView& view = flat.geometry_views[g];
            const MaterialData& m = flat.materials[flat.geometries[g].material];
            float sides = (m.flags & kMaterialDoubleSided) != 0 ? 2.0f : 1.0f;
            for (std::uint32_t p = 0; p < view.triangle_count; ++p) {
                EmitterTriangle e{};
                uvec3 t = view.triangles[p];
                e.p0 = instance.object_to_world * vec4(view.vertices[t.x].position, 1);
                e.p1 = instance.object_to_world * vec4(view.vertices[t.y].position, 1);
                e.p2 = instance.object_to_world * vec4(view.vertices[t.z].position, 1);
                e.instance = i;
                e.geometry = g - instance.first_geometry;
                e.primitive = p;
                const vec3 edge1 = e.p1 - e.p0, edge2 = e.p2 - e.p0;
                const vec3 scaled_normal = cross(edge1, edge2);
                const float area = 0.5f * length(scaled_normal);
                const vec3 farthest = max(max(abs(e.p0), abs(e.p1)), abs(e.p2));
                if (area > 0)
                    e.error = hit_error(transform_magnitude(instance, farthest),
                                        triangle_extent(edge1, edge2), scaled_normal / (2 * area));
                float power = area * sides * std::numbers::pi_v<float> * reader.mean(m, view, p);
                power = power > 0 ? std::min(power, kMaxLightPower) : 0.0f;
                powers.push_back(power);
                flat.emitter_power += double(power);
                flat.emitters.push_back(e);
            }
        }
    }
    flat.emitter_alias = build_alias_table(powers);
}

}  // namespace hm
