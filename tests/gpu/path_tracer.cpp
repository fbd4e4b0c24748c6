#include "gpu/path_tracer.h"

#include "gpu/compute.h"

namespace hm::test {

namespace {

// A storage buffer is never empty: an empty table gets one unused row.
template <class T>
void fill(std::vector<T>& table, std::span<const T> rows) {
    table.assign(rows.begin(), rows.end());
    if (table.empty()) table.resize(1);
}

}  // namespace

PathTracer::PathTracer(const FlatScene& scene) : environment(scene.environment) {
    const ShadingTables& constants = shading_tables();
#define HM_SCENE_TABLE(number, Type, name) fill<Type>(name, scene.name);
#define HM_CONSTANT_TABLE(number, Type, name, rows) fill<Type>(name, constants.name);
#include "shading/tables.inl"
    fill<float>(filter_table, make_filter_table(PixelFilter::gaussian));

    for (const GeometryView& view : scene.geometry_views)
        add_geometry(view);
    for (uint i = 0; i < instances.size(); ++i)
        add_world_triangles(scene, i);
    for (const ImageView& image : scene.images)
        add_image(image);
    world_triangle_count = static_cast<uint>(world_triangles.size());
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
    return {
        bytes_of(reinterpret_cast<std::byte(&)[sizeof(Settings)]>(settings)),
        bytes_of(scene_vertices),
        bytes_of(scene_extras),
        bytes_of(scene_triangles),
        bytes_of(scene_offsets),
        bytes_of(scene_images),
        bytes_of(scene_texels),
        bytes_of(world_triangles),
#define HM_TABLE(number, Type, name) bytes_of(name),
#include "shading/tables.inl"
    };
}

}  // namespace hm::test
