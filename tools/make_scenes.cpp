// Writes the demo scenes into a folder. The output is deterministic.
//
// Usage: make_scenes FOLDER
#include <fmt/format.h>

#include "base/files.h"
#include "base/json_writer.h"
#include "scenes.h"

namespace hm {

Result<void> write_scene(const std::filesystem::path& folder, const std::string& name,
                         const GltfWriter& writer, const DefaultFlags& flags) {
    HM_TRY(writer.write(folder / (name + ".glb")));
    JsonWriter json;
    json.begin_object();
    for (const auto& [flag, value] : flags)
        json.field(flag, value);
    const std::string text = json.end_object().text() + "\n";
    return write_file_atomically(folder / (name + ".json"),
                                 std::as_bytes(std::span<const char>(text)));
}

}  // namespace hm

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_scenes FOLDER\n");
        return int(hm::ErrorKind::invalid_argument);
    }
    for (const auto write : {hm::write_cornell, hm::write_spheres, hm::write_hero})
        if (const auto result = write(argv[1]); !result) {
            fmt::print(stderr, "make_scenes: {}\n", result.error().line());
            return int(result.error().kind);
        }
    return 0;
}
