#include "gltf/attributes.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>

#include "gltf/accessor.h"

namespace hm::gltf {
namespace {

bool is_finite(vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Normalized, or zero if there is no direction. In double, since squares of floats can overflow.
vec3 unit_or_zero(vec3 v) {
    if (!is_finite(v)) return vec3(0);
    const glm::dvec3 exact(v);
    const double size = glm::length(exact);
    return size > 0 ? vec3(exact / size) : vec3(0);
}

vec3 any_perpendicular(vec3 n) {
    const vec3 axis = std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    return normalize(axis - n * dot(n, axis));
}

// Which integers an attribute may use in place of floats.
enum class Encoding { position, direction, coordinate, color };

// KHR_mesh_quantization allows more integer types than core glTF (table in its section "Extending
// Mesh Attributes").
bool is_encoded(const Accessor& accessor, Encoding use, bool quantized) {
    const bool is_small = accessor.component != ComponentType::uint32;
    const bool is_signed =
        accessor.component == ComponentType::int8 || accessor.component == ComponentType::int16;
    if (accessor.component == ComponentType::float32) return true;
    if (!is_small) return false;
    switch (use) {
        case Encoding::position:
            return quantized;
        case Encoding::direction:
            return quantized && is_signed && accessor.normalized;
        case Encoding::coordinate:
            return quantized || (!is_signed && accessor.normalized);
        case Encoding::color:
            return !is_signed && accessor.normalized;
    }
    return false;
}

// An attribute's accessor, after checking its type and count.
Result<std::optional<std::size_t>> find(const Json& attributes, Source& source,
                                        std::string_view key, ElementType type, Encoding encoding,
                                        std::uint32_t count) {
    HM_TRY_ASSIGN(const auto index, attributes.index(key, source.accessors.size(), "accessors"));
    if (!index) return std::nullopt;
    const Accessor& accessor = source.accessors[*index];
    const bool is_color = key == "COLOR_0" && accessor.type == ElementType::vec3;
    if ((accessor.type != type && !is_color) || !is_encoded(accessor, encoding, source.quantized))
        return attributes.invalid(
            key, fmt::format("accessor {} has a type that is invalid for this attribute", *index));
    if (count != 0 && accessor.count != count)
        return attributes.invalid(key, fmt::format("accessor {} has {} elements, POSITION has {}",
                                                   *index, accessor.count, count));
    check_alignment(source, *index);
    return index;
}

template <class Body>
void for_each_vertex(std::size_t count, const Body& body) {
    constexpr std::size_t kGrain = 1 << 14;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kGrain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            body(i);
    });
}

constexpr std::size_t kVertexStride = sizeof(Vertex) / sizeof(float);
constexpr std::size_t kExtraStride = sizeof(VertexExtra) / sizeof(float);

Result<void> read_finite(const Source& source, std::size_t accessor, Target<float> to) {
    HM_TRY(read_floats_to(source, accessor, to));
    return check_finite(source, accessor, {to.first, to.stride});
}

// NaN and infinite texture coordinates, which exporters write when unwrapping failed, become 0.
Result<void> read_coordinates(Source& source, std::size_t accessor, Target<float> to) {
    HM_TRY(read_floats_to(source, accessor, to));
    std::atomic<std::size_t> bad_count = 0;
    for_each_vertex(source.accessors[accessor].count, [&](std::size_t i) {
        float* uv = to.first + i * to.stride;
        if (std::isfinite(uv[0]) && std::isfinite(uv[1])) return;
        for (std::size_t c = 0; c < 2; ++c)
            if (!std::isfinite(uv[c])) uv[c] = 0;
        ++bad_count;
    });
    if (bad_count != 0)
        source.warn(accessor_pointer(accessor), "NaN or infinite texture coordinates; 0 is used",
                    bad_count);
    return {};
}

bool has_extras(const Attributes& attributes) {
    return (attributes.uv1 && attributes.uv1_is_read) || attributes.color;
}

Result<void> read_normals(std::size_t accessor, Source& source, Primitive& primitive) {
    std::vector<Vertex>& vertices = primitive.vertices;
    HM_TRY(read_floats_to(source, accessor, {&vertices[0].normal.x, kVertexStride}));
    std::atomic<bool> all_good = true;
    for_each_vertex(vertices.size(), [&](std::size_t i) {
        vec3& normal = vertices[i].normal;
        normal = unit_or_zero(normal);
        if (normal == vec3(0)) all_good = false;
    });
    if (!all_good)
        source.warn(accessor_pointer(accessor),
                    "some normals are zero or not finite; the face normal is used instead");
    primitive.has_normals = true;
    return {};
}

Result<void> read_tangents(std::size_t accessor, Source& source, Primitive& primitive) {
    std::vector<Vertex>& vertices = primitive.vertices;
    HM_TRY(read_floats_to(source, accessor, {&vertices[0].tangent.x, kVertexStride}));
    std::atomic<bool> all_good = true;
    for_each_vertex(vertices.size(), [&](std::size_t i) {
        Vertex& vertex = vertices[i];
        vec3 direction = unit_or_zero(vec3(vertex.tangent));
        const float sign = vertex.tangent.w;
        if (direction == vec3(0) || std::abs(sign) != 1.0f) all_good = false;
        if (direction == vec3(0)) direction = any_perpendicular(vertex.normal);
        vertex.tangent = vec4(direction, sign < 0 ? -1.0f : 1.0f);
    });
    if (!all_good)
        source.warn(accessor_pointer(accessor),
                    "some tangents have no direction or a w other than 1 or -1; the nearest valid "
                    "ones are used");
    primitive.has_tangents = true;
    return {};
}

// Accessors without alpha leave the preset alpha of 1.
Result<void> read_colors(std::size_t accessor, Source& source, Primitive& primitive) {
    std::vector<VertexExtra>& extras = primitive.extras;
    HM_TRY(read_finite(source, accessor, {&extras[0].color.x, kExtraStride}));
    std::atomic<bool> all_good = true;
    for_each_vertex(extras.size(), [&](std::size_t i) {
        const vec4 clamped = clamp(extras[i].color, vec4(0), vec4(1));
        if (clamped != extras[i].color) all_good = false;
        extras[i].color = clamped;
    });
    if (!all_good)
        source.warn(accessor_pointer(accessor), "vertex colours outside 0 to 1 are clamped");
    return {};
}

}  // namespace

Result<std::optional<Attributes>> read_attributes(const Json& primitive, Source& source) {
    HM_TRY_ASSIGN(const Json json,
                  primitive.required("attributes", primitive.object("attributes")));
    for (const std::string_view key : json.keys())  // including those that are not read
        HM_TRY(json.index(key, source.accessors.size(), "accessors"));
    const auto get = [&](std::string_view key, ElementType type, Encoding encoding,
                         std::uint32_t count) {
        return find(json, source, key, type, encoding, count);
    };
    Attributes out;
    HM_TRY_ASSIGN(const auto position, get("POSITION", ElementType::vec3, Encoding::position, 0));
    if (!position) {
        source.warn(primitive.pointer(), "primitive without POSITION is ignored");
        return std::nullopt;
    }
    out.position = *position;
    out.count = source.accessors[*position].count;
    HM_TRY_ASSIGN(out.normal, get("NORMAL", ElementType::vec3, Encoding::direction, out.count));
    HM_TRY_ASSIGN(out.tangent, get("TANGENT", ElementType::vec4, Encoding::direction, out.count));
    HM_TRY_ASSIGN(out.uv0, get("TEXCOORD_0", ElementType::vec2, Encoding::coordinate, out.count));
    HM_TRY_ASSIGN(out.uv1, get("TEXCOORD_1", ElementType::vec2, Encoding::coordinate, out.count));
    HM_TRY_ASSIGN(out.color, get("COLOR_0", ElementType::vec4, Encoding::color, out.count));
    if (!out.normal) out.tangent.reset();
    return out;
}

std::uint64_t vertex_bytes(const Attributes& attributes) {
    return std::uint64_t{attributes.count} *
           (sizeof(Vertex) + (has_extras(attributes) ? sizeof(VertexExtra) : 0));
}

Result<void> read_vertices(const Attributes& attributes, Source& source, Primitive& primitive) {
    Vertex blank;
    blank.position = vec3(0);
    blank.normal = vec3(0);
    blank.tangent = vec4(0);
    blank.uv0 = vec2(0);
    primitive.vertices.assign(attributes.count, blank);
    Vertex& first = primitive.vertices[0];
    HM_TRY(read_finite(source, attributes.position, {&first.position.x, kVertexStride}));
    check_limits(source, attributes.position, {&first.position.x, kVertexStride});
    if (attributes.normal) HM_TRY(read_normals(*attributes.normal, source, primitive));
    if (attributes.tangent) HM_TRY(read_tangents(*attributes.tangent, source, primitive));
    if (attributes.uv0)
        HM_TRY(read_coordinates(source, *attributes.uv0, {&first.uv0.x, kVertexStride}));
    if (!has_extras(attributes)) return {};
    primitive.extras.assign(attributes.count, VertexExtra{vec2(0), vec4(1)});
    if (attributes.uv1 && attributes.uv1_is_read)
        HM_TRY(
            read_coordinates(source, *attributes.uv1, {&primitive.extras[0].uv1.x, kExtraStride}));
    if (attributes.color) HM_TRY(read_colors(*attributes.color, source, primitive));
    return {};
}

}  // namespace hm::gltf
