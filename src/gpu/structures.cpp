#include "gpu/structures.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <span>
#include <string>

namespace hm {
namespace {

using Rows = std::array<float, 12>;

Rows rows_of(const mat4x3& m) {
    Rows rows{};
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 4; ++c)
            rows[4 * r + c] = m[c][r];
    return rows;
}

std::span<const GeometryData> geometries_of(const FlatScene& scene, std::uint32_t mesh) {
    const std::uint32_t first = scene.mesh_first_geometry[mesh];
    return std::span(scene.geometries).subspan(first, scene.mesh_first_geometry[mesh + 1] - first);
}

bool is_opaque(const FlatScene& scene, const GeometryData& geometry) {
    return scene.materials[geometry.material].alpha_mode == kAlphaOpaque;
}

bool is_opaque(const FlatScene& scene, std::uint32_t mesh) {
    for (const GeometryData& g : geometries_of(scene, mesh))
        if (!is_opaque(scene, g)) return false;
    return true;
}

bool has_triangles(const FlatScene& scene, std::uint32_t mesh) {
    for (const GeometryData& g : geometries_of(scene, mesh))
        if (g.triangle_count > 0) return true;
    return false;
}

// Products of three lengths, and their inverse, stay within floats.
bool inverts_in_floats(const mat4x3& m) {
    const double determinant = std::abs(glm::determinant(glm::dmat3(m)));
    return determinant > 1e-30 && determinant < 1e30;
}

// Equal bits of mesh and transform; -0 and 0 may differ, which costs nothing but memory.
using PlaceKey = std::array<std::uint32_t, 13>;

PlaceKey place_key(const InstanceData& instance) {
    PlaceKey key{};
    const Rows rows = rows_of(instance.object_to_world);
    for (std::size_t i = 0; i < rows.size(); ++i)
        key[i] = std::bit_cast<std::uint32_t>(rows[i]);
    key[12] = instance.mesh;
    return key;
}

rhi::TriangleGeometry triangles_of(const FlatScene& scene, const GpuGeometry& geometry,
                                   std::uint32_t index) {
    const auto address = [](uvec2 words) { return std::uint64_t(words.y) << 32 | words.x; };
    rhi::TriangleGeometry t;
    t.positions = address(geometry.addresses[index].vertices);
    t.position_stride = sizeof(Vertex);
    t.vertex_count = geometry.vertex_counts[index];
    t.indices = address(geometry.addresses[index].triangles);
    t.triangle_count = scene.geometries[index].triangle_count;
    t.opaque = is_opaque(scene, scene.geometries[index]);
    return t;
}

// The transforms of baked instances, by device address.
Result<rhi::Buffer> upload_transforms(rhi::Device& device, rhi::Uploader& uploader,
                                      const FlatScene& scene, const StructurePlan& plan) {
    std::vector<Rows> transforms;
    for (const StructurePlan::Blas& b : plan.blas)
        if (b.baked_instance != kNone)
            transforms.push_back(rows_of(scene.instances[b.baked_instance].object_to_world));
    if (transforms.empty()) return rhi::Buffer{};
    return rhi::upload_buffer(
        uploader, device,
        {"baked transforms", transforms.size() * sizeof(Rows), rhi::BufferUse::build_input},
        std::as_bytes(std::span(transforms)));
}

std::vector<rhi::BlasInput> blas_inputs(const FlatScene& scene, const GpuGeometry& geometry,
                                        const StructurePlan& plan, std::uint64_t transforms) {
    std::vector<rhi::BlasInput> inputs;
    for (const StructurePlan::Blas& b : plan.blas) {
        rhi::BlasInput input;
        input.name = "mesh " + std::to_string(b.mesh);
        for (std::uint32_t g = scene.mesh_first_geometry[b.mesh];
             g < scene.mesh_first_geometry[b.mesh + 1]; ++g) {
            input.geometries.push_back(triangles_of(scene, geometry, g));
            if (b.baked_instance != kNone) input.geometries.back().transform = transforms;
        }
        if (b.baked_instance != kNone) transforms += sizeof(Rows);
        inputs.push_back(std::move(input));
    }
    return inputs;
}

std::vector<rhi::TlasInstance> tlas_instances(const FlatScene& scene, const StructurePlan& plan,
                                              std::span<const rhi::AccelerationStructure> blas) {
    std::vector<rhi::TlasInstance> instances;
    for (const StructurePlan::Placed& p : plan.placed) {
        rhi::TlasInstance instance;
        if (plan.blas[p.blas].baked_instance == kNone)
            instance.transform = rows_of(scene.instances[p.instance].object_to_world);
        instance.custom_index = p.instance;
        instance.blas = blas[p.blas].address();
        instances.push_back(instance);
    }
    return instances;
}

Result<void> check_limits(const rhi::Device& device, const FlatScene& scene) {
    constexpr std::uint64_t kCustomIndices = 1u << 24;
    const std::uint64_t most = std::min(device.limits().max_instances, kCustomIndices);
    if (scene.instances.size() > most)
        return fail(ErrorKind::unsupported, "", "",
                    "the scene has " + std::to_string(scene.instances.size()) + " instances, " +
                        device.physical().name + " takes " + std::to_string(most));
    return {};
}

}  // namespace

StructurePlan plan_structures(const FlatScene& scene) {
    StructurePlan plan;
    std::vector<std::uint32_t> blas_of_mesh(scene.mesh_first_geometry.size() - 1, kNone);
    std::map<PlaceKey, std::uint32_t> placed;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const InstanceData& instance = scene.instances[i];
        if (!has_triangles(scene, instance.mesh)) continue;
        if (is_opaque(scene, instance.mesh) && !placed.emplace(place_key(instance), i).second) {
            ++plan.duplicates;
            continue;
        }
        if (!inverts_in_floats(instance.object_to_world)) {
            plan.blas.push_back({instance.mesh, i});
            plan.placed.push_back({i, std::uint32_t(plan.blas.size()) - 1});
            continue;
        }
        std::uint32_t& blas = blas_of_mesh[instance.mesh];
        if (blas == kNone) {
            blas = std::uint32_t(plan.blas.size());
            plan.blas.push_back({instance.mesh, kNone});
        }
        plan.placed.push_back({i, blas});
    }
    return plan;
}

std::uint64_t SceneStructures::bytes() const {
    std::uint64_t sum = tlas.bytes();
    for (const rhi::AccelerationStructure& b : blas)
        sum += b.bytes();
    return sum;
}

Result<SceneStructures> SceneStructures::build(rhi::Device& device, rhi::Uploader& uploader,
                                               const FlatScene& scene,
                                               const GpuGeometry& geometry) {
    HM_TRY(check_limits(device, scene));
    const StructurePlan plan = plan_structures(scene);
    SceneStructures out;
    out.instances = std::uint32_t(plan.placed.size());
    out.duplicates = plan.duplicates;
    HM_TRY_ASSIGN(const rhi::Buffer transforms, upload_transforms(device, uploader, scene, plan));
    HM_TRY(uploader.finish());
    const std::vector<rhi::BlasInput> inputs =
        blas_inputs(scene, geometry, plan, transforms ? transforms.address() : 0);
    HM_TRY_ASSIGN(out.blas, rhi::build_blas(device, inputs, {}, out.report));
    HM_TRY_ASSIGN(out.tlas, rhi::build_tlas(device, "scene", tlas_instances(scene, plan, out.blas),
                                            out.report));
    return out;
}

}  // namespace hm
