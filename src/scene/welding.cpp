#include "scene/welding.h"

#include <algorithm>
#include <array>
#include <bit>

#include "scene/index_table.h"

namespace hm {
namespace {

using PointBits = std::array<std::uint32_t, 8>;

PointBits bits_of(const SurfacePoint& p) {
    PointBits bits;
    const std::array<float, 8> values = {p.position.x, p.position.y, p.position.z, p.normal.x,
                                         p.normal.y,   p.normal.z,   p.uv.x,       p.uv.y};
    for (std::size_t i = 0; i < bits.size(); ++i)
        bits[i] = std::bit_cast<std::uint32_t>(values[i] + 0.0f);  // -0 becomes 0
    return bits;
}

struct HalfEdge {
    std::uint32_t to;    // the larger of its two vertices
    std::uint32_t edge;  // 3t + i
    bool operator<(const HalfEdge& other) const {
        return to != other.to ? to < other.to : edge < other.edge;
    }
};

// All edges, sorted by their smaller vertex; `begins` holds the offset of each vertex's edges.
struct EdgeTable {
    std::vector<std::uint32_t> begins;
    std::vector<HalfEdge> edges;
};

EdgeTable sort_edges(std::span<const uvec3> triangles, const std::vector<bool>& left_out,
                     std::size_t vertex_count) {
    EdgeTable table;
    table.begins.assign(vertex_count + 2, 0);
    const auto for_each_edge = [&](const auto& visit) {
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (left_out[t]) continue;
            for (std::uint32_t i = 0; i < 3; ++i) {
                const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
                visit(std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(3 * t + i));
            }
        }
    };
    // Counts are stored at an offset of two: filling advances each begin to that of the next
    // vertex.
    for_each_edge(
        [&](std::uint32_t low, std::uint32_t, std::uint32_t) { ++table.begins[low + 2]; });
    for (std::size_t v = 2; v < table.begins.size(); ++v)
        table.begins[v] += table.begins[v - 1];
    table.edges.resize(table.begins.back());
    for_each_edge([&](std::uint32_t low, std::uint32_t high, std::uint32_t edge) {
        table.edges[table.begins[low + 1]++] = {high, edge};
    });
    return table;
}

// Pairs the edges between the same two vertices: each takes the first earlier one that runs in the
// opposite direction and has no partner yet.
void pair_run(std::span<const HalfEdge> run, std::span<const uvec3> triangles,
              std::vector<std::uint32_t>& partners) {
    const auto runs_upwards = [&](const HalfEdge& e) {
        return triangles[e.edge / 3][(e.edge % 3 + 1) % 3] == e.to;
    };
    std::array<std::size_t, 2> first_free{};  // per direction; no earlier edge is free
    for (std::size_t i = 0; i < run.size(); ++i) {
        const bool upwards = runs_upwards(run[i]);
        std::size_t& other = first_free[upwards ? 0 : 1];
        while (other < i &&
               (runs_upwards(run[other]) == upwards || partners[run[other].edge] != kNone))
            ++other;
        if (other == i) continue;
        partners[run[i].edge] = run[other].edge;
        partners[run[other].edge] = run[i].edge;
    }
}

}  // namespace

std::vector<std::uint32_t> weld(std::span<const SurfacePoint> points) {
    std::vector<std::uint32_t> welded(points.size());
    IndexTable table(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PointBits bits = bits_of(points[i]);
        welded[i] =
            table.find_or_add(hash_words(bits), static_cast<std::uint32_t>(i),
                              [&](std::uint32_t other) { return bits_of(points[other]) == bits; });
    }
    return welded;
}

std::vector<std::uint32_t> pair_edges(std::span<const uvec3> triangles,
                                      const std::vector<bool>& left_out, std::size_t vertex_count) {
    std::vector<std::uint32_t> partners(3 * triangles.size(), kNone);
    EdgeTable table = sort_edges(triangles, left_out, vertex_count);
    for (std::size_t v = 0; v < vertex_count; ++v) {
        const auto begin = table.edges.begin() + std::ptrdiff_t(table.begins[v]);
        const auto end = table.edges.begin() + std::ptrdiff_t(table.begins[v + 1]);
        std::sort(begin, end);
        for (auto run = begin; run != end;) {
            const auto run_end =
                std::find_if(run, end, [&](const HalfEdge& e) { return e.to != run->to; });
            pair_run(std::span<const HalfEdge>(run, run_end), triangles, partners);
            run = run_end;
        }
    }
    return partners;
}

}  // namespace hm
