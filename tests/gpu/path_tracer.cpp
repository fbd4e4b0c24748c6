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

    for (const GeometryView& view : scene.geometry_views)
        add_geometry(view);
    for (uint i = 0; i < instances.size(); ++i)
        add_world_triangles(scene, i);
    for (const ImageView& image : scene.images)
        add_image(image);
    world_triangle_count = static_cast<uint>(world_triangles.size());
    keep_one_row(lights);
    keep_one_row(light_alias);
    keep_one_row(emitters);
    keep_one_row(emitter_alias);
}

void PathTracer::add_geometry(const GeometryView& view) {
    scene_offsets.emplace_back(scene_vertices.size(), scene_triangles.size());
    scene_vertices.insert(scene_vertices.end(), view.vertices, view.vertices + view.vertex_count);
    scene_triangles.insert(scene_triangles.end(), view.triangles,
                           view.triangles + view.triangle_count);
    if (view.extras != nullptr)
        scene_extras.insert(scene_extras.end(), view.extras, view.extras + view.vertex_count);
    scene_extras.resize(scene_vertices.size());
}

void PathTracer::add_world_triangles(const FlatScene& scene, uint instance) {
    const InstanceData& placed = instances[instance];
    const uint first = scene.mesh_first_geometry[placed.mesh];
    const uint end = scene.mesh_first_geometry[placed.mesh + 1];
    for (uint geometry = first; geometry < end; ++geometry)
        for (uint i = 0; i < geometries[geometry].triangle_count; ++i) {
            Triangle t;
            load_triangle(geometry, i, t);
            world_triangles.push_back({transform_point(placed.object_to_world, t.a.position),
                                       transform_point(placed.object_to_world, t.b.position),
                                       transform_point(placed.object_to_world, t.c.position),
                                       {instance, geometry - first, i}});
        }
}

void PathTracer::add_image(const ImageView& image) {
    scene_images.emplace_back(scene_texels.size() / 2, image.width, image.height);
    for (std::uint32_t y = 0; y < image.height; ++y)
        for (std::uint32_t x = 0; x < image.width; ++x)
            for (const bool srgb : {false, true})
                scene_texels.push_back(fetch_image_texel(image, x, y, srgb, srgb_table()));
}

std::vector<std::span<std::byte>> PathTracer::buffers(Settings& settings) {
    settings = {params, camera, environment, world_triangle_count};
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
            bytes_of(scene_images),
            bytes_of(scene_texels),
            bytes_of(world_triangles)};
}

}  // namespace hm::test
