// The report of `himalaya info`, written as text or as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/options.h"
#include "base/diagnostics.h"
#include "gltf/summary.h"
#include "scene/flatten.h"
#include "scene/scene.h"

namespace hm::cli {

struct InfoReport {
    std::string input, scene_file;
    std::optional<FileSummary> file;  // none: not even the file's JSON could be read
    std::optional<Scene> scene;       // none: refused for `error`
    std::optional<FlatScene> flat;    // of `scene`
    Diagnostics diagnostics;
    std::optional<Error> error;
};

// Reads the file as for rendering. A file that would be refused is reported, not an error here.
InfoReport examine(const InfoOptions& options);

// Of the chosen scene, not of everything in the file.
struct InfoTotals {
    std::uint64_t primitives = 0, vertices = 0, morph_targets = 0;
    std::uint64_t triangles = 0;        // each mesh once
    std::uint64_t drawn_triangles = 0;  // each instance
    std::uint64_t instances = 0, emissive_triangles = 0;
    std::uint64_t geometry_bytes = 0, image_bytes = 0;
};
InfoTotals totals(const InfoReport& report);

// How many instances show each mesh.
std::vector<std::uint64_t> mesh_uses(const InfoReport& report);

// The slots of a material that have a texture, by their names in glTF.
struct NamedSlot {
    std::string_view role;
    const TextureSlot* slot;
};
std::vector<NamedSlot> used_slots(const Material& material);

// The slots that use each image, without repetition, in the order of the slots.
std::vector<std::vector<std::string_view>> image_roles(const Scene& scene);

std::uint64_t triangle_count(const Mesh& mesh);
std::uint64_t vertex_count(const Mesh& mesh);
std::size_t target_count(const Mesh& mesh);
std::size_t channel_count(const Animation& animation);
double duration(const Animation& animation);  // seconds: the last key of all channels

// "supported", "ignored" or "refused".
std::string_view treatment(const FileExtension& extension);
std::string_view alpha_mode_name(std::uint32_t mode);
std::string_view light_kind_name(std::uint32_t kind);
std::string_view format_name(PixelFormat format);

// Ends with a line feed; control characters from the file are escaped.
std::string info_text(const InfoReport& report);
// docs/info-schema.md describes it.
std::string info_json(const InfoReport& report);

}  // namespace hm::cli
