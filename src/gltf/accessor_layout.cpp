// The accessors array: types, strides and bounds are checked before any data is read (glTF 2.0,
// 3.6.2).
#include <fmt/format.h>

#include <array>
#include <limits>

#include "base/text.h"
#include "gltf/source.h"

namespace hm::gltf {
namespace {

struct TypeName {
    std::string_view name;
    ElementType type;
};
constexpr std::array<TypeName, 7> kTypeNames{{{"SCALAR", ElementType::scalar},
                                              {"VEC2", ElementType::vec2},
                                              {"VEC3", ElementType::vec3},
                                              {"VEC4", ElementType::vec4},
                                              {"MAT2", ElementType::mat2},
                                              {"MAT3", ElementType::mat3},
                                              {"MAT4", ElementType::mat4}}};

// Bytes per element, including the padding that aligns matrix columns to 4 bytes.
std::uint32_t element_size(ComponentType component, ElementType type) {
    const std::uint32_t size = component_size(component);
    const std::uint32_t rows = type == ElementType::mat2   ? 2
                               : type == ElementType::mat3 ? 3
                               : type == ElementType::mat4 ? 4
                                                           : 0;
    if (rows == 0) return size * component_count(type);
    return (rows * size + 3) / 4 * 4 * rows;
}

Result<ComponentType> read_component_type(const Json& item) {
    HM_TRY_ASSIGN(const std::uint64_t value,
                  item.required("componentType", item.integer("componentType")));
    if (value < 5120 || value > 5126 || value == 5124)
        return item.invalid("componentType", fmt::format("{} is not a component type", value));
    return static_cast<ComponentType>(value);
}

Result<ElementType> read_element_type(const Json& item) {
    HM_TRY_ASSIGN(const std::string_view name, item.required("type", item.text("type")));
    for (const TypeName& known : kTypeNames)
        if (known.name == name) return known.type;
    return item.invalid("type", fmt::format("{} is not an element type", excerpt(name)));
}

// Packed elements in a buffer view: the indices or the values of a sparse accessor.
struct Region {
    std::size_t view;
    std::uint64_t offset;
};

Result<Region> read_region(const Json& item, const Source& source, std::uint64_t count,
                           std::uint32_t size, std::uint32_t alignment) {
    Region region{};
    HM_TRY_ASSIGN(
        region.view,
        item.required("bufferView", item.index("bufferView", source.views.size(), "buffer views")));
    HM_TRY_ASSIGN(const auto offset, item.integer("byteOffset"));
    region.offset = offset.value_or(0);
    const BufferView& view = source.views[region.view];
    if (view.stride != 0)
        return item.invalid(
            "bufferView", "the buffer view has a byteStride, which only vertex attributes may use");
    if ((view.offset + region.offset) % alignment != 0)
        return item.invalid("byteOffset", fmt::format("not aligned to {} bytes", alignment));
    if (region.offset > view.length || count * size > view.length - region.offset)
        return item.invalid("", fmt::format("{} elements extend past the end of buffer view {}",
                                            count, region.view));
    return region;
}

Result<SparseElements> read_sparse(const Json& item, const Source& source,
                                   const Accessor& accessor) {
    SparseElements sparse;
    HM_TRY_ASSIGN(sparse.count, item.required("count", item.integer("count")));
    if (sparse.count == 0 || sparse.count > accessor.count)
        return item.invalid("count", fmt::format("{} is not between 1 and the accessor's count, {}",
                                                 sparse.count, accessor.count));
    HM_TRY_ASSIGN(const Json indices, item.required("indices", item.object("indices")));
    HM_TRY_ASSIGN(sparse.index_type, read_component_type(indices));
    if (sparse.index_type != ComponentType::uint8 && sparse.index_type != ComponentType::uint16 &&
        sparse.index_type != ComponentType::uint32)
        return indices.invalid("componentType", "sparse indices must be unsigned integers");
    const std::uint32_t index_size = component_size(sparse.index_type);
    HM_TRY_ASSIGN(const Region at,
                  read_region(indices, source, sparse.count, index_size, index_size));
    HM_TRY_ASSIGN(const Json values, item.required("values", item.object("values")));
    HM_TRY_ASSIGN(
        const Region value_at,
        read_region(values, source, sparse.count, element_size(accessor.component, accessor.type),
                    component_size(accessor.component)));
    sparse.index_view = at.view;
    sparse.index_offset = at.offset;
    sparse.value_view = value_at.view;
    sparse.value_offset = value_at.offset;
    return sparse;
}

// Sets the stride; checks alignment and bounds within the view.
Result<void> check_view(const Json& item, const Source& source, Accessor& accessor) {
    const BufferView& view = source.views[*accessor.view];
    const std::uint32_t size = element_size(accessor.component, accessor.type);
    const std::uint32_t alignment = component_size(accessor.component);
    accessor.stride = view.stride == 0 ? size : view.stride;
    if (accessor.stride < size)
        return item.invalid("bufferView",
                            fmt::format("its byteStride, {}, is less than the element size, {}",
                                        accessor.stride, size));
    if (accessor.stride % alignment != 0 || (view.offset + accessor.offset) % alignment != 0)
        return item.invalid("byteOffset", fmt::format("not aligned to {} bytes", alignment));
    // Cannot overflow: offset <= 2^53, stride <= 252, count < 2^32.
    const std::uint64_t end =
        accessor.offset + std::uint64_t{accessor.stride} * (accessor.count - 1) + size;
    if (end > view.length)
        return item.invalid("", fmt::format("ends at byte {} of buffer view {}, which has {} bytes",
                                            end, *accessor.view, view.length));
    return {};
}

// "min" or "max": one number per component; empty if absent.
Result<std::vector<float>> read_limit(const Json& item, std::string_view key, ElementType type) {
    std::vector<float> limit;
    if (!item.has(key)) return limit;
    limit.resize(component_count(type));
    HM_TRY(item.numbers(key, limit));
    return limit;
}

Result<Accessor> read_accessor(const Json& item, Source& source) {
    Accessor accessor;
    HM_TRY(name_of(item));
    HM_TRY_ASSIGN(accessor.component, read_component_type(item));
    HM_TRY_ASSIGN(accessor.type, read_element_type(item));
    HM_TRY_ASSIGN(accessor.normalized, item.flag("normalized"));
    if (accessor.normalized && (accessor.component == ComponentType::float32 ||
                                accessor.component == ComponentType::uint32)) {
        source.warn(item.pointer_of("normalized"),
                    "only 8-bit and 16-bit integers can be normalized; ignored");
        accessor.normalized = false;
    }
    HM_TRY_ASSIGN(const std::uint64_t count, item.required("count", item.integer("count")));
    if (count == 0 || count >= std::numeric_limits<std::uint32_t>::max())
        return item.invalid("count", fmt::format("{} is not in the range 1 to 2^32 - 2", count));
    accessor.count = static_cast<std::uint32_t>(count);
    HM_TRY_ASSIGN(accessor.view, item.index("bufferView", source.views.size(), "buffer views"));
    HM_TRY_ASSIGN(const auto offset, item.integer("byteOffset"));
    accessor.offset = offset.value_or(0);
    if (accessor.view) HM_TRY(check_view(item, source, accessor));
    HM_TRY_ASSIGN(const auto sparse, item.object("sparse"));
    if (sparse) {
        HM_TRY_ASSIGN(accessor.sparse, read_sparse(*sparse, source, accessor));
    }
    HM_TRY_ASSIGN(accessor.min, read_limit(item, "min", accessor.type));
    HM_TRY_ASSIGN(accessor.max, read_limit(item, "max", accessor.type));
    return accessor;
}

}  // namespace

std::uint32_t component_size(ComponentType type) {
    switch (type) {
        case ComponentType::int8:
        case ComponentType::uint8:
            return 1;
        case ComponentType::int16:
        case ComponentType::uint16:
            return 2;
        case ComponentType::uint32:
        case ComponentType::float32:
            return 4;
    }
    return 4;
}

std::uint32_t component_count(ElementType type) {
    constexpr std::array<std::uint32_t, 7> kCounts{1, 2, 3, 4, 4, 9, 16};
    return kCounts[static_cast<std::size_t>(type)];
}

Result<void> read_accessors(const Json& root, Source& source) {
    HM_TRY_ASSIGN(const std::vector<Json> items, root.objects("accessors"));
    for (const Json& item : items) {
        HM_TRY_ASSIGN(Accessor accessor, read_accessor(item, source));
        source.accessors.push_back(std::move(accessor));
    }
    return {};
}

}  // namespace hm::gltf
