// SPDX-License-Identifier: LGPL-2.1-or-later
#include "layered_depth/reconstruction/border_stitching.h"

#include <algorithm>
#include <tuple>

#include "base/predicates.h"

namespace mq::layered_depth {

namespace {

/// Marks a triangle that has been removed.
constexpr mesh::Triangle kGone{-1, -1, -1};

/// A new vertex on a border edge.
struct EdgeSplit {
    std::int32_t edge;
    double at;  // parameter along the edge
    std::int32_t leaf;
    std::int32_t vertex;
};

class Stitcher {
  public:
    Stitcher(const Octree& tree, const SampleGrid& grid, RetainedSurface& surface, StitchCounts& counts)
        : tree_(tree), grid_(grid), surface_(surface), counts_(counts), vertex_(tree.sheets.size(), -1) {}

    std::vector<std::int32_t> run();

  private:
    std::int32_t& vertex_of(const Leaf& leaf) { return vertex_[leaf.first_sheet + leaf.border_sheet]; }
    const Vec3& minimiser_of(const Leaf& leaf) const {
        return tree_.sheets[leaf.first_sheet + leaf.border_sheet].minimiser;
    }
    Vec3 point_on(std::int32_t edge, double at) const {
        const RetainedSurface::BorderEdge& e = surface_.border[edge];
        return (1.0 - at) * surface_.points[e.from] + at * surface_.points[e.to];
    }
    void plan_splits();
    double nearest_parameter(const CellEdge& edge, const Vec3& target) const;
    void apply_splits();
    void split_triangle(std::int32_t triangle, const std::vector<std::int32_t>& edges);
    void build_fans();
    std::vector<std::int32_t>& fan(std::int32_t point) { return fans_[fan_of_[point]]; }
    std::vector<std::int32_t> nodes_in(std::size_t leaf) const;
    void merge_nodes(std::size_t leaf);
    bool would_flatten(std::int32_t keep, std::int32_t gone);
    bool collapse(std::int32_t keep, std::int32_t gone);
    void directed_edges(std::int32_t point, std::int32_t except, std::vector<std::int32_t>& out);
    bool move(std::int32_t point, const Vec3& to);
    void drop_gone();

    const Octree& tree_;
    const SampleGrid& grid_;
    RetainedSurface& surface_;
    StitchCounts& counts_;
    std::vector<std::int32_t> vertex_;       // by leaf: its vertex
    std::vector<EdgeSplit> splits_;          // sorted by edge, then by parameter
    std::vector<std::int32_t> first_split_;  // first entry in splits_ of each border edge, and the end
    std::vector<std::int32_t> fan_of_;       // by point: its index in fans_; -1 off the border
    std::vector<std::vector<std::int32_t>> fans_;
    std::vector<std::int32_t> around_keep_, around_gone_;
};

double Stitcher::nearest_parameter(const CellEdge& edge, const Vec3& target) const {
    const Vec3 a = point_on(edge.edge, 0.0), d = point_on(edge.edge, 1.0) - a;
    const double at = (grid_.to_space(target) - a).dot(d) / d.squaredNorm();
    // Keeps the split away from the wall of the cell, as the neighbour may split the edge, too.
    const double inset = 0.05 * (edge.to - edge.from);
    return std::clamp(at, edge.from + inset, edge.to - inset);
}

void Stitcher::plan_splits() {
    for (std::size_t k = 0; k < tree_.leaves.size(); ++k) {
        const Leaf& leaf = tree_.leaves[k];
        if (leaf.kind == CellKind::Interior) {
            continue;
        }
        ++counts_.boundary_cells;
        const auto id = static_cast<std::int32_t>(k);
        const CellEdge& first = tree_.edges[leaf.first_edge];
        if (leaf.kind == CellKind::SingleEdge) {
            splits_.push_back({first.edge, nearest_parameter(first, minimiser_of(leaf)), id, -1});
        } else if (leaf.kind == CellKind::SharedVertex) {
            const RetainedSurface::BorderEdge& e = surface_.border[first.edge];
            vertex_of(leaf) = leaf.holds(grid_.to_grid(surface_.points[e.from])) ? e.from : e.to;
        } else {
            ++counts_.complex_cells;
            for (std::uint32_t i = leaf.first_edge; i < leaf.end_edge; ++i) {
                const CellEdge& e = tree_.edges[i];
                const RetainedSurface::BorderEdge& ends = surface_.border[e.edge];
                if (!leaf.holds(grid_.to_grid(surface_.points[ends.from])) &&
                    !leaf.holds(grid_.to_grid(surface_.points[ends.to])) && e.to - e.from > 1e-6) {
                    splits_.push_back({e.edge, 0.5 * (e.from + e.to), id, -1});
                }
            }
        }
    }
}

void Stitcher::apply_splits() {
    std::sort(splits_.begin(), splits_.end(), [](const EdgeSplit& a, const EdgeSplit& b) {
        return std::tie(a.edge, a.at, a.leaf) < std::tie(b.edge, b.at, b.leaf);
    });
    first_split_.assign(surface_.border.size() + 1, 0);
    for (EdgeSplit& split : splits_) {
        split.vertex = static_cast<std::int32_t>(surface_.points.size());
        surface_.points.push_back(to_single(point_on(split.edge, split.at)));
        ++first_split_[split.edge + 1];
        if (tree_.leaves[split.leaf].kind == CellKind::SingleEdge) {
            vertex_of(tree_.leaves[split.leaf]) = split.vertex;
        }
    }
    for (std::size_t k = 1; k < first_split_.size(); ++k) {
        first_split_[k] += first_split_[k - 1];
    }
    surface_.on_border.resize(surface_.points.size(), 1);
    counts_.split_edges = splits_.size();
    std::vector<std::array<std::int32_t, 2>> by_triangle;
    for (std::size_t k = 0; k < surface_.border.size(); ++k) {
        if (first_split_[k] < first_split_[k + 1]) {
            by_triangle.push_back({surface_.border[k].triangle, static_cast<std::int32_t>(k)});
        }
    }
    std::sort(by_triangle.begin(), by_triangle.end());
    std::vector<std::int32_t> edges;
    for (std::size_t i = 0; i < by_triangle.size();) {
        const std::int32_t triangle = by_triangle[i][0];
        edges.clear();
        for (; i < by_triangle.size() && by_triangle[i][0] == triangle; ++i) {
            edges.push_back(by_triangle[i][1]);
        }
        split_triangle(triangle, edges);
    }
}

/// Divides a triangle at its split edges: for each of these edges in turn into a fan.
void Stitcher::split_triangle(std::int32_t triangle, const std::vector<std::int32_t>& edges) {
    std::vector<std::int32_t> pieces{triangle};
    surface_.source[triangle] = -1;
    for (const std::int32_t edge : edges) {
        const RetainedSurface::BorderEdge& e = surface_.border[edge];
        for (const std::int32_t piece : pieces) {
            mesh::Triangle t = surface_.triangles[piece];
            int corner = 0;
            while (corner < 3 && (t[corner] != e.from || t[(corner + 1) % 3] != e.to)) {
                ++corner;
            }
            if (corner == 3) {
                continue;
            }
            const std::int32_t apex = t[(corner + 2) % 3];
            std::int32_t from = e.from;
            for (std::int32_t s = first_split_[edge]; s <= first_split_[edge + 1]; ++s) {
                const std::int32_t to = s < first_split_[edge + 1] ? splits_[s].vertex : e.to;
                if (s == first_split_[edge]) {
                    surface_.triangles[piece] = {from, to, apex};
                } else {
                    pieces.push_back(static_cast<std::int32_t>(surface_.triangles.size()));
                    surface_.triangles.push_back({from, to, apex});
                    surface_.source.push_back(-1);
                    surface_.lies_on.push_back(surface_.lies_on[triangle]);
                }
                from = to;
            }
            break;
        }
    }
}

void Stitcher::build_fans() {
    fan_of_.assign(surface_.points.size(), -1);
    std::int32_t count = 0;
    for (std::size_t p = 0; p < surface_.points.size(); ++p) {
        if (surface_.on_border[p] != 0) {
            fan_of_[p] = count++;
        }
    }
    fans_.resize(count);
    for (std::size_t k = 0; k < surface_.triangles.size(); ++k) {
        for (const std::int32_t p : surface_.triangles[k]) {
            if (fan_of_[p] >= 0) {
                fan(p).push_back(static_cast<std::int32_t>(k));
            }
        }
    }
}

/// The other ends of the directed edges of triangles without `except`: x for an edge from `point` to x, -1 - x for one
/// from x.
void Stitcher::directed_edges(std::int32_t point, std::int32_t except, std::vector<std::int32_t>& out) {
    out.clear();
    for (const std::int32_t k : fan(point)) {
        const mesh::Triangle& t = surface_.triangles[k];
        const int i = t[0] == point ? 0 : t[1] == point ? 1 : 2;
        const std::int32_t next = t[(i + 1) % 3], previous = t[(i + 2) % 3];
        if (next != except && previous != except) {
            out.push_back(next);
            out.push_back(-1 - previous);
        }
    }
    std::sort(out.begin(), out.end());
}

/// Whether a triangle around vertex `gone` would lose its area if `gone` moved onto `keep`. Triangles with both
/// vertices vanish and do not count.
bool Stitcher::would_flatten(std::int32_t keep, std::int32_t gone) {
    const std::vector<std::int32_t>& around = fan(gone);
    return std::any_of(around.begin(), around.end(), [&](std::int32_t k) {
        mesh::Triangle t = surface_.triangles[k];
        if (std::find(t.begin(), t.end(), keep) != t.end()) {
            return false;
        }
        std::replace(t.begin(), t.end(), gone, keep);
        return collinear(surface_.points[t[0]], surface_.points[t[1]], surface_.points[t[2]]);
    });
}

/// Merges two border vertices; triangles that have both vanish. Refused if two triangles would have the same directed
/// edge, or if a triangle would lose its area.
bool Stitcher::collapse(std::int32_t keep, std::int32_t gone) {
    directed_edges(keep, gone, around_keep_);
    directed_edges(gone, keep, around_gone_);
    for (const std::int32_t edge : around_gone_) {
        if (std::binary_search(around_keep_.begin(), around_keep_.end(), edge)) {
            return false;
        }
    }
    if (would_flatten(keep, gone)) {
        return false;
    }
    for (const std::int32_t k : fan(gone)) {
        mesh::Triangle& t = surface_.triangles[k];
        if (t[0] == keep || t[1] == keep || t[2] == keep) {
            for (const std::int32_t p : t) {
                if (p != gone && fan_of_[p] >= 0) {
                    fan(p).erase(std::find(fan(p).begin(), fan(p).end(), k));
                }
            }
            t = kGone;
            continue;
        }
        std::replace(t.begin(), t.end(), gone, keep);
        surface_.source[k] = -1;
        fan(keep).push_back(k);
    }
    fan(gone).clear();
    return true;
}

/// Moves a border vertex. False if a triangle around it would turn over or vanish.
bool Stitcher::move(std::int32_t point, const Vec3& to) {
    for (const std::int32_t k : fan(point)) {
        std::array<Vec3, 3> now, then;
        for (int i = 0; i < 3; ++i) {
            const std::int32_t p = surface_.triangles[k][i];
            now[i] = surface_.points[p];
            then[i] = p == point ? to : now[i];
        }
        const Vec3 before = (now[1] - now[0]).cross(now[2] - now[0]);
        const Vec3 after = (then[1] - then[0]).cross(then[2] - then[0]);
        if (before.dot(after) <= 0.0) {
            return false;
        }
    }
    surface_.points[point] = to;
    for (const std::int32_t k : fan(point)) {
        surface_.source[k] = -1;
    }
    return true;
}

/// The border vertices in a complex cell, ascending.
std::vector<std::int32_t> Stitcher::nodes_in(std::size_t k) const {
    const Leaf& leaf = tree_.leaves[k];
    std::vector<std::int32_t> nodes;
    for (std::uint32_t i = leaf.first_edge; i < leaf.end_edge; ++i) {
        const std::int32_t edge = tree_.edges[i].edge;
        for (const std::int32_t p : {surface_.border[edge].from, surface_.border[edge].to}) {
            if (leaf.holds(grid_.to_grid(surface_.points[p]))) {
                nodes.push_back(p);
            }
        }
        for (std::int32_t s = first_split_[edge]; s < first_split_[edge + 1]; ++s) {
            if (splits_[s].leaf == static_cast<std::int32_t>(k)) {
                nodes.push_back(splits_[s].vertex);
            }
        }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

void Stitcher::merge_nodes(std::size_t leaf) {
    std::vector<std::int32_t> nodes = nodes_in(leaf);
    if (nodes.empty()) {
        return;
    }
    bool merged = false;
    for (bool again = true; again;) {
        again = false;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (std::size_t j = nodes.size() - 1; j > i; --j) {
                if (collapse(nodes[i], nodes[j])) {
                    nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(j));
                    ++counts_.collapsed_nodes;
                    again = merged = true;
                }
            }
        }
    }
    const Vec3 target = to_single(grid_.to_space(minimiser_of(tree_.leaves[leaf])));
    const std::int32_t chosen = *std::min_element(nodes.begin(), nodes.end(), [&](std::int32_t a, std::int32_t b) {
        return (surface_.points[a] - target).squaredNorm() < (surface_.points[b] - target).squaredNorm();
    });
    vertex_of(tree_.leaves[leaf]) = chosen;
    counts_.left_nodes += nodes.size() - 1;
    if (merged && move(chosen, target)) {
        ++counts_.moved_nodes;
    }
}

void Stitcher::drop_gone() {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < surface_.triangles.size(); ++k) {
        if (surface_.triangles[k] != kGone) {
            surface_.triangles[kept] = surface_.triangles[k];
            surface_.lies_on[kept] = surface_.lies_on[k];
            surface_.source[kept++] = surface_.source[k];
        }
    }
    surface_.triangles.resize(kept);
    surface_.source.resize(kept);
    surface_.lies_on.resize(kept);
}

std::vector<std::int32_t> Stitcher::run() {
    plan_splits();
    apply_splits();
    build_fans();
    for (std::size_t k = 0; k < tree_.leaves.size(); ++k) {
        if (tree_.leaves[k].kind == CellKind::Complex) {
            merge_nodes(k);
        }
    }
    drop_gone();
    return vertex_;
}

}  // namespace

std::vector<std::int32_t> stitch(const Octree& tree, const SampleGrid& grid, RetainedSurface& surface,
                                 StitchCounts& counts) {
    return Stitcher(tree, grid, surface, counts).run();
}

}  // namespace mq::layered_depth
