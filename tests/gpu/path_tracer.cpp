#include "gpu/path_tracer.h"

#include "gpu/compute.h"

namespace hm::test {

namespace {

// A storage buffer is never empty; one unused row stands for none.
template <class T>
void keep_one_row(std::vector<T>& table) {
    if (table.empty()) table.resize(1);
}

}  // namespace

PathTracer::PathTracer(const FlatScene& scene)
    : environment(scene.environment.data),
      instance_count(static_cast<uint>(scene.instances.size())),
      materials(scene.materials),
      texture_uses(scene.texture_uses),
      geometries(scene.geometries),
      instances(scene.instances),
      lights(scene.lights),
      light_alias(scene.light_alias),
      emitters(scene.emitters),
      emitter_alias(scene.emitter_alias),
      environment_texels(scene.environment.texels),
      environment_alias(scene.environment.alias) {
    const ShadingTables& tables = shading_tables();
    sobol_directions.assign(tables.sobol_directions.begin(), tables.sobol_directions.end());
    sobol_nibbles.assign(tables.sobol_nibbles.begin(), tables.sobol_nibbles.end());
    blue_noise.assign(tables.blue_noise.begin(), tables.blue_noise.end());
    albedo_table.assign(tables.albedo_table.begin(), tables.albedo_table.end());
    albedo_average.assign(tables.albedo_average.begin(), tables.albedo_average.end());
    const auto filter = make_filter_table(PixelFilter::gaussian);
    filter_table.assign(filter.begin(), filter.end());

    for (const GeometryView& view : scene.geometry_views) {
        scene_offsets.emplace_back(scene_vertices.size(), scene_triangles.size());
        scene_vertices.insert(scene_vertices.end(), view.vertices,
                              view.vertices + view.vertex_count);
        scene_triangles.insert(scene_triangles.end(), view.triangles,
                               view.triangles + view.triangle_count);
        if (view.extras != nullptr)
            scene_extras.insert(scene_extras.end(), view.extras, view.extras + view.vertex_count);
        scene_extras.resize(scene_vertices.size());
    }
    for (const InstanceData& instance : instances)
        mesh_geometry_counts.push_back(scene.mesh_first_geometry[instance.mesh + 1] -
                                       scene.mesh_first_geometry[instance.mesh]);
    for (const ImageView& image : scene.images) {
        scene_images.emplace_back(scene_texels.size(), image.width, image.height);
        const auto* texels = static_cast<const std::uint8_t*>(image.pixels);
        for (std::size_t i = 0; i < std::size_t(image.width) * image.height; ++i, texels += 4)
            scene_texels.push_back(texels[0] | uint(texels[1]) << 8 | uint(texels[2]) << 16 |
                                   uint(texels[3]) << 24);
    }
    keep_one_row(lights);
    keep_one_row(light_alias);
    keep_one_row(emitters);
    keep_one_row(emitter_alias);
}

std::vector<std::span<std::byte>> PathTracer::buffers(Settings& settings) {
    settings = {params, camera, environment, instance_count};
    return {bytes_of(reinterpret_cast<std::byte(&)[sizeof(Settings)]>(settings)),
            bytes_of(sobol_directions),
            bytes_of(sobol_nibbles),
            bytes_of(blue_noise),
            bytes_of(albedo_table),
            bytes_of(albedo_average),
            bytes_of(filter_table),
            bytes_of(materials),
            bytes_of(texture_uses),
            bytes_of(geometries),
            bytes_of(instances),
            bytes_of(lights),
            bytes_of(light_alias),
            bytes_of(emitters),
            bytes_of(emitter_alias),
            bytes_of(environment_texels),
            bytes_of(environment_alias),
            bytes_of(scene_vertices),
            bytes_of(scene_extras),
            bytes_of(scene_triangles),
            bytes_of(scene_offsets),
            bytes_of(mesh_geometry_counts),
            bytes_of(scene_images),
            bytes_of(scene_texels)};
}

}  // namespace hm::test
