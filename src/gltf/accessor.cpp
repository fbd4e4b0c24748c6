// Accessors (glTF 2.0, 3.6.2): layout checks and decoding.
#include "gltf/accessor.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace hm::gltf {
namespace {

static_assert(std::endian::native == std::endian::little, "buffers are read without byte swapping");

template <class T>
T load(const std::byte* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

// Converts a stored component by glTF's rules for normalized integers (3.6.2.2).
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

// Elements per task.
constexpr std::size_t kGrain = 1 << 16;

template <class Body>
void for_ranges(std::size_t count, const Body& body) {
    if (count <= kGrain) return body(std::size_t{0}, count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain),
                      [&](const auto& range) { body(range.begin(), range.end()); });
}

template <std::size_t kWidth, class T, class Out>
void decode_range(const Elements& from, bool normalized, Target<Out> to, std::size_t begin,
                  std::size_t end) {
    const std::size_t width = kWidth == 0 ? from.width : kWidth;
    for (std::size_t i = begin; i < end; ++i) {
        const std::byte* element = from.first + i * from.stride;
        Out* out = to.first + i * to.stride;
        for (std::size_t c = 0; c < width; ++c) {
            const T value = load<T>(element + c * sizeof(T));
            if constexpr (std::is_floating_point_v<Out>)
                out[c] = to_float(value, normalized);
            else
                out[c] = static_cast<Out>(value);
        }
    }
}

// A compile-time width lets the compiler unroll the inner loop for common types.
template <class T, class Out>
void decode_as(const Elements& from, bool normalized, Target<Out> to) {
    for_ranges(from.count, [&](std::size_t begin, std::size_t end) {
        if (from.width == 1) return decode_range<1, T>(from, normalized, to, begin, end);
        if (from.width == 2) return decode_range<2, T>(from, normalized, to, begin, end);
        if (from.width == 3) return decode_range<3, T>(from, normalized, to, begin, end);
        if (from.width == 4) return decode_range<4, T>(from, normalized, to, begin, end);
        decode_range<0, T>(from, normalized, to, begin, end);
    });
}

template <class Out>
void decode(ComponentType type, const Elements& from, bool normalized, Target<Out> to) {
    switch (type) {
        case ComponentType::int8:
            return decode_as<std::int8_t>(from, normalized, to);
        case ComponentType::uint8:
            return decode_as<std::uint8_t>(from, normalized, to);
        case ComponentType::int16:
            return decode_as<std::int16_t>(from, normalized, to);
        case ComponentType::uint16:
            return decode_as<std::uint16_t>(from, normalized, to);
        case ComponentType::uint32:
            return decode_as<std::uint32_t>(from, normalized, to);
        case ComponentType::float32:
            return decode_as<float>(from, normalized, to);
    }
}

// The indices of a sparse accessor: strictly increasing and below the accessor's count.
Result<std::vector<std::uint32_t>> sparse_indices(const Source& source, std::size_t accessor,
                                                  const SparseElements& sparse) {
    HM_TRY_ASSIGN(const auto bytes, view_bytes(source, sparse.index_view));
    std::vector<std::uint32_t> indices(sparse.count);
    const Elements from{bytes.data() + sparse.index_offset, component_size(sparse.index_type),
                        sparse.count, 1};
    decode(sparse.index_type, from, false, Target<std::uint32_t>{indices.data(), 1});
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const bool rises = i == 0 || indices[i] > indices[i - 1];
        if (!rises || indices[i] >= source.accessors[accessor].count)
            return fail(ErrorKind::invalid, source.file,
                        accessor_pointer(accessor) + "/sparse/indices",
                        fmt::format("index {} (element {}) {}", indices[i], i,
                                    rises ? "is past the end of the accessor"
                                          : "is not greater than the one before"));
    }
    return indices;
}

template <class Out>
Result<void> read_sparse(const Source& source, std::size_t index, Target<Out> to) {
    const Accessor& accessor = source.accessors[index];
    const SparseElements& sparse = *accessor.sparse;
    const std::size_t width = component_count(accessor.type);
    HM_TRY_ASSIGN(const auto indices, sparse_indices(source, index, sparse));
    HM_TRY_ASSIGN(const auto bytes, view_bytes(source, sparse.value_view));
    std::vector<Out> values(indices.size() * width);
    const Elements from{bytes.data() + sparse.value_offset,
                        component_size(accessor.component) * width, indices.size(), width};
    decode(accessor.component, from, accessor.normalized, Target<Out>{values.data(), width});
    for (std::size_t i = 0; i < indices.size(); ++i)
        std::copy_n(values.data() + i * width, width, to.first + indices[i] * to.stride);
    return {};
}

// Converts a component of `min` or `max` like a decoded element's.
float decoded(float stored, const Accessor& accessor) {
    if (!accessor.normalized) return stored;
    switch (accessor.component) {
        case ComponentType::int8:
            return std::max(stored / 127.0f, -1.0f);
        case ComponentType::uint8:
            return stored / 255.0f;
        case ComponentType::int16:
            return std::max(stored / 32767.0f, -1.0f);
        case ComponentType::uint16:
            return stored / 65535.0f;
        case ComponentType::uint32:
        case ComponentType::float32:
            return stored;
    }
    return stored;
}

struct Limits {
    std::array<float, 16> min, max;
};

// The minimum and maximum of each component.
Limits limits_of(std::size_t count, std::size_t width, Target<const float> values) {
    Limits none;
    none.min.fill(std::numeric_limits<float>::infinity());
    none.max.fill(-std::numeric_limits<float>::infinity());
    const auto join = [width](Limits a, const Limits& b) {
        for (std::size_t c = 0; c < width; ++c) {
            a.min[c] = std::min(a.min[c], b.min[c]);
            a.max[c] = std::max(a.max[c], b.max[c]);
        }
        return a;
    };
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, count, kGrain), none,
        [&](const auto& range, Limits found) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) {
                const float* element = values.first + i * values.stride;
                for (std::size_t c = 0; c < width; ++c) {
                    found.min[c] = std::min(found.min[c], element[c]);
                    found.max[c] = std::max(found.max[c], element[c]);
                }
            }
            return found;
        },
        join);
}

template <class Out>
Result<void> read_to(const Source& source, std::size_t index, Target<Out> to) {
    const Accessor& accessor = source.accessors[index];
    const std::size_t width = component_count(accessor.type);
    if (accessor.view) {
        HM_TRY_ASSIGN(const auto bytes, view_bytes(source, *accessor.view));
        const Elements from{bytes.data() + accessor.offset, accessor.stride, accessor.count, width};
        decode(accessor.component, from, accessor.normalized, to);
    } else {
        for (std::size_t i = 0; i < accessor.count; ++i)
            std::fill_n(to.first + i * to.stride, width, Out(0));
    }
    return accessor.sparse ? read_sparse(source, index, to) : Result<void>();
}

template <class Out>
Result<std::vector<Out>> read_all(const Source& source, std::size_t index) {
    const std::size_t width = component_count(source.accessors[index].type);
    std::vector<Out> out(source.accessors[index].count * width);
    HM_TRY(read_to(source, index, Target<Out>{out.data(), width}));
    return out;
}

}  // namespace

std::string accessor_pointer(std::size_t accessor) {
    return fmt::format("/accessors/{}", accessor);
}

Result<std::vector<float>> read_floats(const Source& source, std::size_t accessor) {
    return read_all<float>(source, accessor);
}

Result<std::vector<std::uint32_t>> read_integers(const Source& source, std::size_t accessor) {
    return read_all<std::uint32_t>(source, accessor);
}

Result<void> read_floats_to(const Source& source, std::size_t accessor, Target<float> to) {
    return read_to(source, accessor, to);
}

Result<void> read_integers_to(const Source& source, std::size_t accessor,
                              Target<std::uint32_t> to) {
    return read_to(source, accessor, to);
}

Result<void> check_finite(const Source& source, std::size_t accessor,
                          const std::vector<float>& values) {
    return check_finite(source, accessor,
                        {values.data(), component_count(source.accessors[accessor].type)});
}

Result<void> check_finite(const Source& source, std::size_t accessor, Target<const float> values) {
    const std::size_t width = component_count(source.accessors[accessor].type);
    const std::size_t count = source.accessors[accessor].count;
    std::atomic<std::size_t> first_bad = count;
    for_ranges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            // x * 0 is 0 for finite x and NaN otherwise.
            float sum = 0;
            for (std::size_t c = 0; c < width; ++c)
                sum += values.first[i * values.stride + c] * 0.0f;
            if (sum == 0.0f) continue;
            for (std::size_t known = first_bad; i < known;)
                if (first_bad.compare_exchange_weak(known, i)) break;
            return;
        }
    });
    const std::size_t bad = first_bad;
    if (bad == count) return {};
    const float* element = values.first + bad * values.stride;
    const bool nan = std::any_of(element, element + width, [](float x) { return std::isnan(x); });
    return fail(ErrorKind::invalid, source.file, accessor_pointer(accessor),
                fmt::format("element {} is {}", bad, nan ? "NaN" : "infinite"));
}

void check_limits(Source& source, std::size_t index, Target<const float> values) {
    const Accessor& accessor = source.accessors[index];
    if (accessor.min.empty() || accessor.max.empty())
        return source.warn(accessor_pointer(index),
                           "min and max are missing, which this use requires");
    const std::size_t width = accessor.min.size();
    const Limits found = limits_of(accessor.count, width, values);
    for (std::size_t c = 0; c < width; ++c)
        if (decoded(accessor.min[c], accessor) != found.min[c] ||
            decoded(accessor.max[c], accessor) != found.max[c])
            return source.warn(accessor_pointer(index),
                               "min and max do not match the elements; the elements are used");
}

void check_alignment(Source& source, std::size_t index) {
    const Accessor& accessor = source.accessors[index];
    if (accessor.view && (accessor.offset % 4 != 0 || accessor.stride % 4 != 0))
        source.warn(accessor_pointer(index), "vertex data is not aligned to 4 bytes");
}

}  // namespace hm::gltf
