// Accessors (glTF 2.0, 3.6.2): layout checks and decoding.
#include "gltf/accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace hm::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "buffers are read as they stand");

template <class T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

// A stored component as glTF's rules for normalized integers say (3.6.2.2).
template <class T>
float to_float(T value, bool normalized) {
    if constexpr (std::is_floating_point_v<T>) {
        return value;
    } else {
        if (!normalized) return static_cast<float>(value);
        const float scaled =
            static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max());
        return std::max(scaled, -1.0f);
    }
}

struct Elements {
    const std::byte* first;
    std::size_t stride;
    std::size_t count;
    std::size_t width;  // components each
};

template <class T, class Out>
void decode_as(const Elements& from, bool normalized, Out* out) {
    for (std::size_t i = 0; i < from.count; ++i) {
        const std::byte* element = from.first + i * from.stride;
        for (std::size_t c = 0; c < from.width; ++c) {
            const T value = load<T>(element + c * sizeof(T));
            if constexpr (std::is_floating_point_v<Out>)
                *out++ = to_float(value, normalized);
            else
                *out++ = static_cast<Out>(value);
        }
    }
}

template <class Out>
void decode(ComponentType type, const Elements& from, bool normalized, Out* out) {
    switch (type) {
        case ComponentType::int8:
            return decode_as<std::int8_t>(from, normalized, out);
        case ComponentType::uint8:
            return decode_as<std::uint8_t>(from, normalized, out);
        case ComponentType::int16:
            return decode_as<std::int16_t>(from, normalized, out);
        case ComponentType::uint16:
            return decode_as<std::uint16_t>(from, normalized, out);
        case ComponentType::uint32:
            return decode_as<std::uint32_t>(from, normalized, out);
        case ComponentType::float32:
            return decode_as<float>(from, normalized, out);
    }
}

// The indices of a sparse accessor: strictly increasing and below the accessor's count.
Result<std::vector<std::uint32_t>> sparse_indices(const Source& source, std::size_t accessor,
                                                  const SparseElements& sparse) {
    HM_TRY_ASSIGN(const auto bytes, view_bytes(source, sparse.index_view));
    std::vector<std::uint32_t> indices(sparse.count);
    decode(sparse.index_type,
           {bytes.data() + sparse.index_offset, component_size(sparse.index_type), sparse.count, 1},
           false, indices.data());
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const bool rises = i == 0 || indices[i] > indices[i - 1];
        if (!rises || indices[i] >= source.accessors[accessor].count)
            return fail(ExitCode::invalid, source.file,
                        accessor_place(accessor) + "/sparse/indices",
                        fmt::format("index {} (element {}) {}", indices[i], i,
                                    rises ? "is past the accessor's end" : "does not increase"));
    }
    return indices;
}

template <class Out>
Result<std::vector<Out>> read_components(const Source& source, std::size_t index) {
    const Accessor& accessor = source.accessors[index];
    const std::size_t width = component_count(accessor.type);
    std::vector<Out> out(accessor.count * width);
    if (accessor.view) {
        HM_TRY_ASSIGN(const auto bytes, view_bytes(source, *accessor.view));
        decode(accessor.component,
               {bytes.data() + accessor.offset, accessor.stride, accessor.count, width},
               accessor.normalized, out.data());
    }
    if (!accessor.sparse) return out;

    const SparseElements& sparse = *accessor.sparse;
    HM_TRY_ASSIGN(const auto indices, sparse_indices(source, index, sparse));
    HM_TRY_ASSIGN(const auto bytes, view_bytes(source, sparse.value_view));
    std::vector<Out> values(indices.size() * width);
    decode(accessor.component,
           {bytes.data() + sparse.value_offset, component_size(accessor.component) * width,
            indices.size(), width},
           accessor.normalized, values.data());
    for (std::size_t i = 0; i < indices.size(); ++i)
        std::copy_n(values.begin() + std::ptrdiff_t(i * width), width,
                    out.begin() + std::ptrdiff_t(indices[i] * width));
    return out;
}

}  // namespace

std::string accessor_place(std::size_t accessor) {
    return fmt::format("/accessors/{}", accessor);
}

Result<std::vector<float>> read_floats(const Source& source, std::size_t accessor) {
    return read_components<float>(source, accessor);
}

Result<std::vector<std::uint32_t>> read_integers(const Source& source, std::size_t accessor) {
    return read_components<std::uint32_t>(source, accessor);
}

Result<void> check_finite(const Source& source, std::size_t accessor,
                          const std::vector<float>& values) {
    const auto bad =
        std::find_if(values.begin(), values.end(), [](float x) { return !std::isfinite(x); });
    if (bad == values.end()) return {};
    const std::size_t width = component_count(source.accessors[accessor].type);
    return fail(ExitCode::invalid, source.file, accessor_place(accessor),
                fmt::format("element {} is {}", std::size_t(bad - values.begin()) / width,
                            std::isnan(*bad) ? "not a number" : "infinite"));
}

}  // namespace hm::gltf
