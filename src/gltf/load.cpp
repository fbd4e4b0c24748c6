// The order of loading: container, JSON, buffers and accessors, then the parts of the scene.
#include "gltf/load.h"

#include <algorithm>
#include <new>
#include <system_error>

#include "base/files.h"
#include "gltf/animations.h"
#include "gltf/asset.h"
#include "gltf/budget.h"
#include "gltf/cameras_lights.h"
#include "gltf/container.h"
#include "gltf/document.h"
#include "gltf/images.h"
#include "gltf/instances.h"
#include "gltf/materials.h"
#include "gltf/meshes.h"
#include "gltf/nodes.h"
#include "gltf/skins.h"
#include "gltf/source.h"
#include "gltf/variants.h"
#include "scene/origin.h"
#include "scene/pose.h"
#include "scene/tangents.h"

namespace hm {
namespace {

std::vector<bool> used_materials(const Scene& scene) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            if (primitive.material != kUnset) used[std::size_t(primitive.material)] = true;
    return used;
}

Result<Scene> load(std::span<const std::byte> bytes, const std::filesystem::path& path,
                   Diagnostics& diagnostics, const LoadOptions& options) {
    using namespace gltf;
    const std::string file = path.string();
    HM_TRY_ASSIGN(const Container container, split_container(bytes, file, diagnostics));
    Source source{file, path.parent_path(), diagnostics, options, container.binary};
    source.hash.add(bytes);
    source.budget = make_budget(memory_limit(options), bytes.size());
    HM_TRY(check_memory(source.budget, json_memory(container.json), file, ""));
    source.budget.kept_bytes -= json_memory(container.json);
    const auto after_json = bytes.last(
        bytes.size() - std::size_t(container.json.data() + container.json.size() - bytes.data()));
    HM_TRY_ASSIGN(const JsonDocument document,
                  parse_document(container.json, file, after_json.size()));
    const Json& root = document.root();
    HM_TRY(check_asset(root));

    HM_TRY(check_extensions(document, source));
    HM_TRY(choose_variant(root, source));
    HM_TRY(read_buffers(root, source));
    HM_TRY(read_buffer_views(root, source));
    HM_TRY(read_accessors(root, source));

    Scene scene;
    scene.file = file;
    HM_TRY_ASSIGN(scene.generator, generator_of(root));
    HM_TRY_ASSIGN(scene.materials, read_materials(root, source));
    HM_TRY_ASSIGN(scene.meshes, read_meshes(root, source, scene.materials));
    HM_TRY_ASSIGN(scene.images, read_images(root, source, scene.materials, used_materials(scene)));
    prepare_tangents(scene);
    HM_TRY_ASSIGN(scene.cameras, read_cameras(root, source));
    HM_TRY_ASSIGN(scene.lights, read_lights(root, source));
    HM_TRY_ASSIGN(const std::vector<int> scene_node, read_nodes(root, source, scene));
    HM_TRY_ASSIGN(scene.skins, read_skins(root, source, scene_node, scene));
    HM_TRY(check_skinned_nodes(source, scene_node, scene));
    HM_TRY_ASSIGN(scene.animations, read_animations(root, source, scene_node, scene));
    set_origin(scene);
    if (std::any_of(scene.meshes.begin(), scene.meshes.end(), is_deformable)) {
        HM_TRY(separate_posed_meshes(source, scene));
        HM_TRY(
            pose_scene(scene, std::nullopt));  // otherwise everything is in its rest pose already
    }
    scene.hash = source.hash.text();
    return scene;
}

}  // namespace

Result<Scene> load_gltf(const std::filesystem::path& path, Diagnostics& diagnostics,
                        const LoadOptions& options) {
    // If the size is unknown, read_file reports the error.
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    const gltf::Budget whole = gltf::make_budget(gltf::memory_limit(options), 0);
    if (!unknown) HM_TRY(gltf::check_memory(whole, size, path.string(), ""));
    HM_TRY_ASSIGN(const ByteArray bytes, read_file(path));
    return load_gltf_bytes(bytes, path, diagnostics, options);
}

Result<Scene> load_gltf_bytes(std::span<const std::byte> bytes, const std::filesystem::path& path,
                              Diagnostics& diagnostics, const LoadOptions& options) {
    try {
        return load(bytes, path, diagnostics, options);
    } catch (const std::bad_alloc&) {
        return fail(ErrorKind::internal, path.string(), "", "the scene does not fit in memory");
    }
}

}  // namespace hm
