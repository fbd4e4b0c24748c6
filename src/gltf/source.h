// State shared by the parts of the loader: buffers, buffer views and accessors (glTF 2.0, 3.6), the
// options and the budget. Everything is validated once; later stages index without checks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/result.h"
#include "gltf/json.h"
#include "gltf/load.h"

namespace hm::gltf {

// byteLength bytes, or nullopt if the buffer has no source (extensions may provide one).
struct Buffer {
    std::optional<std::span<const std::byte>> bytes;
    std::uint64_t length = 0;
};

struct BufferView {
    std::size_t buffer = 0;
    std::uint64_t offset = 0;  // offset + length is within the buffer
    std::uint64_t length = 0;
    std::uint32_t stride = 0;  // 0: elements are packed
};

// The values are glTF's (those of OpenGL).
enum class ComponentType : std::uint32_t {
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126,
};

enum class ElementType { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };

// Sparse storage: `count` packed indices and as many packed values that replace elements.
struct SparseElements {
    std::uint64_t count = 0;
    std::size_t index_view = 0;
    std::uint64_t index_offset = 0;
    ComponentType index_type = ComponentType::uint8;
    std::size_t value_view = 0;
    std::uint64_t value_offset = 0;
};

struct Accessor {
    ComponentType component = ComponentType::float32;
    ElementType type = ElementType::scalar;
    bool normalized = false;
    std::uint32_t count = 0;
    std::optional<std::size_t> view;  // none: zeros
    std::uint64_t offset = 0;         // into the view; the last element is within the view
    std::uint32_t stride = 0;
    std::optional<SparseElements> sparse;
    std::vector<float> min, max;  // as in the file, not normalized; empty if absent
};

// What is left of the limits. A small file can reference the same bytes many times.
struct Budget {
    std::uint64_t kept_bytes = 0;     // memory that is held until loading ends
    std::uint64_t decoded_bytes = 0;  // work: all decoded data, including temporary data
    std::uint64_t limit = 0;          // initial kept_bytes, for messages
};

struct Source {
    std::string file;
    std::filesystem::path folder;
    Diagnostics& diagnostics;
    LoadOptions options{};
    std::optional<std::span<const std::byte>> binary{};  // GLB's BIN chunk
    std::vector<ByteArray> storage{};                    // external and data URI buffers
    std::vector<Buffer> buffers{};
    std::vector<BufferView> views{};
    std::vector<Accessor> accessors{};
    Budget budget{};
    Hasher hash{};           // of the file and all files it references
    bool quantized = false;  // KHR_mesh_quantization is used
    std::size_t variant_count = 0;
    std::optional<std::size_t> variant{};  // the chosen index

    void note(std::string pointer, std::string message, std::size_t count = 1) {
        diagnostics.note(file, std::move(pointer), std::move(message), count);
    }
    void warn(std::string pointer, std::string message, std::size_t count = 1) {
        diagnostics.warn(file, std::move(pointer), std::move(message), count);
    }
};

std::uint32_t component_size(ComponentType type);
std::uint32_t component_count(ElementType type);

// Fill the respective arrays from the root object. Must be called in this order.
Result<void> read_buffers(const Json& root, Source& source);
Result<void> read_buffer_views(const Json& root, Source& source);
Result<void> read_accessors(const Json& root, Source& source);

// The bytes of a buffer view. Fails if its buffer has no source.
Result<std::span<const std::byte>> view_bytes(const Source& source, std::size_t view);

// Reads the data of a data URI or file, and charges it to the budget. `owner` is the buffer or
// image that has the "uri".
Result<ByteArray> read_uri(Source& source, const Json& owner, std::string_view uri);

}  // namespace hm::gltf
