#include "scene/tangent_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace hm {
namespace {

using glm::dvec3;

constexpr double kTiny = double(std::numeric_limits<float>::min());  // zero in the reference

// Larger groups are averaged as a whole, even with opposite directions: testing all pairs would let
// a crafted file take hours.
constexpr std::size_t kMaxSplitGroup = 256;

struct TriangleFrame {
    vec3 along_u{0};  // unit, or zero
    vec3 along_v{0};
    bool preserving = false;  // not mirrored: UVs have the same winding as the triangle
    bool oriented = false;    // false: zero UV area
    bool no_extent = false;   // degenerate: two corners coincide
};

dvec3 unit_or_zero(dvec3 v) {
    const double size = glm::length(v);
    return size > kTiny ? v / size : dvec3(0);
}

// Projected onto the plane of a normal and normalized.
dvec3 projected(dvec3 v, dvec3 normal) {
    return unit_or_zero(v - normal * glm::dot(normal, v));
}

TriangleFrame frame_of(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c) {
    TriangleFrame frame;
    frame.no_extent =
        a.position == b.position || a.position == c.position || b.position == c.position;
    // In float, as in the reference: rounding decides what counts as zero area. The directions are
    // in double, which cannot overflow for finite input.
    const vec2 ab = b.uv - a.uv, ac = c.uv - a.uv;
    const float area = ab.x * ac.y - ab.y * ac.x;
    frame.preserving = area > 0;
    if (!(std::abs(area) > std::numeric_limits<float>::min())) return frame;
    const dvec3 edge1 = dvec3(b.position) - dvec3(a.position);
    const dvec3 edge2 = dvec3(c.position) - dvec3(a.position);
    const glm::dvec2 d1 = glm::dvec2(b.uv) - glm::dvec2(a.uv);
    const glm::dvec2 d2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    const double sign = frame.preserving ? 1 : -1;
    const dvec3 u = (edge1 * d2.y - edge2 * d1.y) * sign;
    const dvec3 v = (edge2 * d1.x - edge1 * d2.x) * sign;
    frame.along_u = vec3(unit_or_zero(u));
    frame.along_v = vec3(unit_or_zero(v));
    const double size = std::abs(double(area));
    frame.oriented = glm::length(u) / size > kTiny && glm::length(v) / size > kTiny;
    return frame;
}

struct Surface {
    std::span<const SurfacePoint> points;
    std::vector<uvec3> triangles;  // indices of welded points
    std::vector<TriangleFrame> frames;
    std::vector<std::uint32_t> neighbours;  // per edge (see pair_edges)

    std::uint32_t vertex(std::uint32_t corner) const { return triangles[corner / 3][corner % 3]; }
};

std::uint32_t next(std::uint32_t corner) {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}
std::uint32_t previous(std::uint32_t corner) {
    return corner % 3 == 0 ? corner + 2 : corner - 1;
}

// The corner of the same vertex in the triangle across the edge that leaves it, or that arrives at
// it; kNone if there is none. Edges are indexed by their start corner; the neighbouring edge runs
// in the opposite direction.
std::uint32_t across_leaving(const Surface& s, std::uint32_t corner) {
    const std::uint32_t edge = s.neighbours[corner];
    return edge == kNone ? kNone : next(edge);
}
std::uint32_t across_arriving(const Surface& s, std::uint32_t corner) {
    return s.neighbours[previous(corner)];
}

// One corner of a group: directions projected to the normal's plane, and the angle in that plane.
struct Member {
    std::uint32_t corner;
    bool oriented;
    dvec3 along_u, along_v;
    double angle;
};

Member member_of(const Surface& s, std::uint32_t corner) {
    const TriangleFrame& frame = s.frames[corner / 3];
    Member m{corner, frame.oriented, dvec3(0), dvec3(0), 0};
    if (!frame.oriented) return m;
    const SurfacePoint& point = s.points[s.vertex(corner)];
    const dvec3 normal(point.normal), position(point.position);
    m.along_u = projected(dvec3(frame.along_u), normal);
    m.along_v = projected(dvec3(frame.along_v), normal);
    const dvec3 a(s.points[s.vertex(previous(corner))].position);
    const dvec3 b(s.points[s.vertex(next(corner))].position);
    const dvec3 edge1 = projected(a - position, normal), edge2 = projected(b - position, normal);
    m.angle = std::acos(std::clamp(glm::dot(edge1, edge2), -1.0, 1.0));
    return m;
}

// Exactly opposite, to float precision.
bool opposed(const Member& a, const Member& b) {
    if (!a.oriented || !b.oriented) return false;
    return float(glm::dot(a.along_u, b.along_u)) <= -1.0f ||
           float(glm::dot(a.along_v, b.along_v)) <= -1.0f;
}

class Groups {
  public:
    explicit Groups(const Surface& surface)
        : surface_(surface),
          grouped_(3 * surface.triangles.size(), false),
          preserving_(surface.triangles.size()),
          tangents_(grouped_.size(), vec4(1, 0, 0, 1)) {
        for (std::size_t t = 0; t < preserving_.size(); ++t)
            preserving_[t] = surface.frames[t].preserving;
    }

    std::vector<vec4> make() {
        for (std::uint32_t corner = 0; corner < grouped_.size(); ++corner) {
            const TriangleFrame& frame = surface_.frames[corner / 3];
            if (grouped_[corner] || frame.no_extent || !frame.oriented) continue;
            gather(corner);
            average();
        }
        return std::move(tangents_);
    }

  private:
    // Walks around the vertex in both directions until an edge has no neighbour or the orientation
    // flips.
    void gather(std::uint32_t start) {
        members_.clear();
        group_preserving_ = preserving_[start / 3];
        take(start);
        for (auto c = across_leaving(surface_, start); takes(c); c = across_leaving(surface_, c))
            take(c);
        for (auto c = across_arriving(surface_, start); takes(c); c = across_arriving(surface_, c))
            take(c);
        // Sorted by triangle, so that the sums round the same wherever the walk started.
        std::sort(members_.begin(), members_.end(),
                  [](const Member& a, const Member& b) { return a.corner < b.corner; });
    }

    bool takes(std::uint32_t corner) {
        if (corner == kNone || grouped_[corner]) return false;
        const std::uint32_t t = corner / 3;
        const bool undecided = !surface_.frames[t].oriented && !grouped_[3 * t] &&
                               !grouped_[3 * t + 1] && !grouped_[3 * t + 2];
        if (undecided) preserving_[t] = group_preserving_;
        return preserving_[t] == group_preserving_;
    }

    void take(std::uint32_t corner) {
        grouped_[corner] = true;
        members_.push_back(member_of(surface_, corner));
    }

    void average() {
        if (members_.size() > kMaxSplitGroup || !may_be_split()) {
            const vec4 tangent = mean([](const Member&) { return true; });
            for (const Member& m : members_)
                tangents_[m.corner] = tangent;
            return;
        }
        for (const Member& m : members_)
            tangents_[m.corner] = mean([&](const Member& other) { return !opposed(m, other); });
    }

    // Directions in one half space are never opposite; this holds for almost all groups.
    bool may_be_split() const {
        const auto first = std::find_if(members_.begin(), members_.end(),
                                        [](const Member& m) { return m.oriented; });
        return std::any_of(first, members_.end(), [&](const Member& m) {
            return m.oriented && (glm::dot(first->along_u, m.along_u) < 1e-3 ||
                                  glm::dot(first->along_v, m.along_v) < 1e-3);
        });
    }

    template <class Choice>
    vec4 mean(const Choice& chosen) const {
        dvec3 sum(0);
        for (const Member& m : members_)
            if (chosen(m)) sum += m.along_u * m.angle;
        vec3 tangent(unit_or_zero(sum));
        if (tangent == vec3(0)) tangent = vec3(1, 0, 0);
        return vec4(tangent, group_preserving_ ? -1.0f : 1.0f);
    }

    const Surface& surface_;
    std::vector<bool> grouped_;     // per corner
    std::vector<bool> preserving_;  // per triangle, including those set by a group
    std::vector<vec4> tangents_;
    std::vector<Member> members_;  // of the current group
    bool group_preserving_ = false;
};

void fill_triangles_without_extent(const Surface& s, std::vector<vec4>& tangents) {
    std::vector<std::uint32_t> first_corner(s.points.size(), kNone);
    for (std::uint32_t corner = 0; corner < tangents.size(); ++corner)
        if (!s.frames[corner / 3].no_extent && first_corner[s.vertex(corner)] == kNone)
            first_corner[s.vertex(corner)] = corner;
    for (std::uint32_t corner = 0; corner < tangents.size(); ++corner)
        if (s.frames[corner / 3].no_extent && first_corner[s.vertex(corner)] != kNone)
            tangents[corner] = tangents[first_corner[s.vertex(corner)]];
}

}  // namespace

std::vector<vec4> corner_tangents(std::span<const SurfacePoint> points,
                                  std::span<const uvec3> triangles) {
    HM_CHECK(triangles.size() < kNone / 3, "{} triangles", triangles.size());
    Surface surface{points, {triangles.begin(), triangles.end()}, {}, {}};
    const std::vector<std::uint32_t> welded = weld(points);
    for (uvec3& t : surface.triangles)
        t = uvec3(welded[t.x], welded[t.y], welded[t.z]);
    std::vector<bool> left_out(triangles.size());
    surface.frames.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const uvec3 t = surface.triangles[i];
        surface.frames.push_back(frame_of(points[t.x], points[t.y], points[t.z]));
        left_out[i] = surface.frames.back().no_extent;
    }
    surface.neighbours = pair_edges(surface.triangles, left_out, points.size());
    std::vector<vec4> tangents = Groups(surface).make();
    fill_triangles_without_extent(surface, tangents);
    return tangents;
}

}  // namespace hm
