#include "gltf/attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gltf/accessor.h"

namespace hm::gltf {
namespace {

using Values = std::vector<float>;

vec3 vec3_at(const Values& values, std::size_t i) {
    return vec3(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
}

bool is_finite(vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Unit length, or zero for what has no direction. Through double: squares of floats overflow.
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

enum class Encoding { floats, floats_or_normalized };

bool is_encoded(const Accessor& accessor, Encoding allowed) {
    if (accessor.component == ComponentType::float32) return true;
    return allowed == Encoding::floats_or_normalized && accessor.normalized &&
           (accessor.component == ComponentType::uint8 ||
            accessor.component == ComponentType::uint16);
}

// One attribute's accessor, its type and count checked.
Result<std::optional<std::size_t>> find(const Json& attributes, const Source& source,
                                        std::string_view key, ElementType type, Encoding encoding,
                                        std::uint32_t count) {
    HM_TRY_ASSIGN(const auto index, attributes.index(key, source.accessors.size(), "accessors"));
    if (!index) return std::nullopt;
    const Accessor& accessor = source.accessors[*index];
    const bool is_color = key == "COLOR_0" && accessor.type == ElementType::vec3;
    if ((accessor.type != type && !is_color) || !is_encoded(accessor, encoding))
        return attributes.invalid(
            key, fmt::format("accessor {} has a type that this attribute can't have", *index));
    if (count != 0 && accessor.count != count)
        return attributes.invalid(key, fmt::format("accessor {} has {} elements, POSITION has {}",
                                                   *index, accessor.count, count));
    return index;
}

Result<Values> read_finite(const Source& source, std::size_t accessor) {
    HM_TRY_ASSIGN(Values values, read_floats(source, accessor));
    HM_TRY(check_finite(source, accessor, values));
    return values;
}

Result<void> read_normals(std::size_t accessor, Source& source, Primitive& primitive) {
    HM_TRY_ASSIGN(const Values values, read_floats(source, accessor));
    bool all_good = true;
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
        vec3& normal = primitive.vertices[i].normal;
        normal = unit_or_zero(vec3_at(values, i));
        all_good = all_good && normal != vec3(0);
    }
    if (!all_good)
        source.warn(accessor_place(accessor),
                    "some normals are zero or not finite; there the face's own normal is used");
    primitive.has_normals = true;
    return {};
}

Result<void> read_tangents(std::size_t accessor, Source& source, Primitive& primitive) {
    HM_TRY_ASSIGN(const Values values, read_floats(source, accessor));
    bool all_good = true;
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
        Vertex& vertex = primitive.vertices[i];
        vec3 direction = unit_or_zero(vec3(values[4 * i], values[4 * i + 1], values[4 * i + 2]));
        const float sign = values[4 * i + 3];
        if (direction == vec3(0) || std::abs(sign) != 1.0f) all_good = false;
        if (direction == vec3(0)) direction = any_perpendicular(vertex.normal);
        vertex.tangent = vec4(direction, sign < 0 ? -1.0f : 1.0f);
    }
    if (!all_good)
        source.warn(accessor_place(accessor),
                    "some tangents have no direction or a w other than 1 and -1; the nearest valid "
                    "ones are used");
    primitive.has_tangents = true;
    return {};
}

Result<void> read_colors(std::size_t accessor, Source& source, Primitive& primitive) {
    HM_TRY_ASSIGN(const Values values, read_finite(source, accessor));
    const std::size_t width = source.accessors[accessor].type == ElementType::vec4 ? 4 : 3;
    if (std::any_of(values.begin(), values.end(), [](float x) { return x < 0 || x > 1; }))
        source.warn(accessor_place(accessor), "vertex colours outside 0 to 1, clamped");
    for (std::size_t i = 0; i < primitive.extras.size(); ++i) {
        vec4 color(1);
        for (std::size_t c = 0; c < width; ++c)
            color[c] = std::clamp(values[width * i + c], 0.0f, 1.0f);
        primitive.extras[i].color = color;
    }
    return {};
}

}  // namespace

Result<std::optional<Attributes>> read_attributes(const Json& primitive, Source& source) {
    HM_TRY_ASSIGN(const Json json,
                  primitive.required("attributes", primitive.object("attributes")));
    const auto get = [&](std::string_view key, ElementType type, Encoding encoding,
                         std::uint32_t count) {
        return find(json, source, key, type, encoding, count);
    };
    constexpr Encoding kAny = Encoding::floats_or_normalized;
    Attributes out;
    HM_TRY_ASSIGN(const auto position, get("POSITION", ElementType::vec3, Encoding::floats, 0));
    if (!position) {
        source.warn(primitive.place(), "a primitive without positions is left out");
        return std::nullopt;
    }
    out.position = *position;
    out.count = source.accessors[*position].count;
    HM_TRY_ASSIGN(out.normal, get("NORMAL", ElementType::vec3, Encoding::floats, out.count));
    HM_TRY_ASSIGN(out.tangent, get("TANGENT", ElementType::vec4, Encoding::floats, out.count));
    HM_TRY_ASSIGN(out.uv0, get("TEXCOORD_0", ElementType::vec2, kAny, out.count));
    HM_TRY_ASSIGN(out.uv1, get("TEXCOORD_1", ElementType::vec2, kAny, out.count));
    HM_TRY_ASSIGN(out.color, get("COLOR_0", ElementType::vec4, kAny, out.count));
    if (!out.normal) out.tangent.reset();
    return out;
}

std::uint64_t vertex_bytes(const Attributes& attributes) {
    const bool extras = attributes.uv1 || attributes.color;
    return std::uint64_t{attributes.count} * (sizeof(Vertex) + (extras ? sizeof(VertexExtra) : 0));
}

Result<void> read_vertices(const Attributes& attributes, Source& source, Primitive& primitive) {
    Vertex blank;
    blank.position = vec3(0);
    blank.normal = vec3(0);
    blank.tangent = vec4(0);
    blank.uv0 = vec2(0);
    primitive.vertices.assign(attributes.count, blank);
    HM_TRY_ASSIGN(Values values, read_finite(source, attributes.position));
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
        primitive.vertices[i].position = vec3_at(values, i);
    if (attributes.normal) HM_TRY(read_normals(*attributes.normal, source, primitive));
    if (attributes.tangent) HM_TRY(read_tangents(*attributes.tangent, source, primitive));
    if (attributes.uv0) {
        HM_TRY_ASSIGN(values, read_finite(source, *attributes.uv0));
        for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
            primitive.vertices[i].uv0 = vec2(values[2 * i], values[2 * i + 1]);
    }
    if (!attributes.uv1 && !attributes.color) return {};
    primitive.extras.assign(attributes.count, VertexExtra{vec2(0), vec4(1)});
    if (attributes.uv1) {
        HM_TRY_ASSIGN(values, read_finite(source, *attributes.uv1));
        for (std::size_t i = 0; i < primitive.extras.size(); ++i)
            primitive.extras[i].uv1 = vec2(values[2 * i], values[2 * i + 1]);
    }
    if (attributes.color) HM_TRY(read_colors(*attributes.color, source, primitive));
    return {};
}

}  // namespace hm::gltf
