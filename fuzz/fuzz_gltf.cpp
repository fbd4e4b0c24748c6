// libFuzzer: any bytes as a glTF file. Whatever they say, the loader answers with a scene or an
// error. Files that the bytes name are looked for in a folder that does not exist.
#include <cstddef>
#include <cstdint>
#include <span>

#include "gltf/load.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    hm::Diagnostics diagnostics;
    const std::span<const std::uint8_t> bytes(data, size);
    hm::LoadOptions options;
    options.memory_limit = 1u << 28;
    const auto scene =
        hm::load_gltf_bytes(std::as_bytes(bytes), "/nonexistent/fuzzed.glb", diagnostics, options);
    if (!scene && scene.error().line().empty()) __builtin_trap();
    for (const hm::Warning& warning : diagnostics.warnings())
        if (warning.line().empty()) __builtin_trap();
    return 0;
}
