// SPDX-License-Identifier: LGPL-2.1-or-later
#include "wrap/surface/crossings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/parallel.h"
#include "contour/tuning.h"
#include "wrap/lattice/tuning.h"
#include "wrap/surface/graded_cells.h"

namespace mq::wrap {

using contour::CrossedCell;
using contour::CrossedCells;
using contour::Crossing;

namespace {

/// Least distance of a crossing that closes a gap from both ends of its edge, as a fraction of the edge: the input has
/// no surface there that would have to be kept.
constexpr double kGapEnds = 0.05;

/// An edge of the lattice between a node outside and a node that is not outside.
struct Edge {
    Node outer;
    Node inner;
};

/// The key of an edge, made of its middle, which no other edge has.
std::uint64_t edge_key(const Edge& edge) {
    constexpr int kBits = 21;  // enough for the sum of two node coordinates
    const Node sum = edge.outer + edge.inner;
    return (static_cast<std::uint64_t>(sum[0]) << 2 * kBits) | (static_cast<std::uint64_t>(sum[1]) << kBits) |
           static_cast<std::uint64_t>(sum[2]);
}

/// Finds the cells of one block after another, and numbers the edges that they share.
class CellSearch {
  public:
    explicit CellSearch(const NodeStates& states) : states_(states) {}

    void run(const GradedCells& cells, CrossedCells& result, Progress& progress) {
        double done = 0.0;
        for (const std::array<std::int32_t, 3>& block : cells.blocks()) {
            progress.check();
            progress.advance(0.5 * done++ / static_cast<double>(cells.blocks().size()));
            cells.for_each_tetrahedron(block, [&](const std::array<Node, 4>& cell) { visit(cell, result); });
        }
    }
    std::vector<Edge> edges;

  private:
    void visit(const std::array<Node, 4>& cell, CrossedCells& result) {
        for (const Node& node : cell) {
            if (!states_.lattice().contains(node)) {
                return;
            }
        }
        std::array<bool, 4> is_outside{};
        for (std::size_t k = 0; k < 4; ++k) {
            is_outside[k] = states_.is_outside(cell[k]);
        }
        if (std::equal(is_outside.begin() + 1, is_outside.end(), is_outside.begin())) {
            return;
        }
        CrossedCell found;
        for (std::size_t k = 0; k < 4; ++k) {
            found.corners[k] = states_.position(cell[k]);
        }
        found.polygon = contour::cell_polygon(found.corners, is_outside);
        for (std::size_t k = 0; k < static_cast<std::size_t>(found.polygon.count); ++k) {
            const auto& [outer, inner] = found.polygon.edges[k];
            const Edge edge{cell[static_cast<std::size_t>(outer)], cell[static_cast<std::size_t>(inner)]};
            const auto [at, is_new] = numbers_.insert({edge_key(edge), static_cast<std::int32_t>(edges.size())});
            if (is_new) {
                edges.push_back(edge);
            }
            found.crossings[k] = at->second;
        }
        result.cells.push_back(found);
    }

    const NodeStates& states_;
    KeyMap<std::int32_t> numbers_;
};

/// The fraction of the segment from `from` to `to` at which the distance from the input falls to `distance`.
double share_to_distance(const InputSurface& surface, const Vec3& from, const Vec3& to, double distance) {
    constexpr double kFine = 1e-3;  // a fraction of the distance
    const double length = (to - from).norm();
    double share = 0.0;
    while (share < 1.0) {
        const double left = surface.tree.nearest(from + share * (to - from)).distance - distance;
        if (left <= kFine * distance) {
            break;
        }
        share += left / length;
    }
    return std::min(share, 1.0);
}

Crossing at_share(double share, const Vec3& outer, const Vec3& inner) {
    Crossing result;
    result.on_input = outer + share * (inner - outer);
    result.point =
        outer +
        std::clamp(share, contour::ContourTuning::kEndShare, 1.0 - contour::ContourTuning::kEndShare) * (inner - outer);
    return result;
}

Crossing at_sheet(const InputSurface& surface, const Vec3& outer, const Vec3& inner, double half) {
    Crossing result = at_share(share_to_distance(surface, outer, inner, half), outer, inner);
    const mesh::ClosestPoint nearest = surface.tree.nearest(result.on_input);
    result.source = nearest.triangle;
    result.normal = (result.on_input - nearest.point).normalized();
    return result;
}

/// Where a segment passes the plane of the triangle that is nearest to its middle.
FirstMeeting plane_meeting(const InputSurface& surface, const Vec3& outer, const Vec3& inner) {
    const mesh::ClosestPoint nearest = surface.tree.nearest(0.5 * (outer + inner));
    const Vec3 normal = surface.normal(nearest.triangle);
    const double ahead = normal.dot(inner - outer);
    return {ahead != 0.0 ? std::clamp(normal.dot(nearest.point - outer) / ahead, 0.0, 1.0) : 0.5, nearest.triangle};
}

Crossing at_input(const InputSurface& surface, const Vec3& outer, const Vec3& inner) {
    FirstMeeting first = surface.first_meeting(outer, inner);
    if (first.triangle < 0) {
        first = plane_meeting(surface, outer, inner);
    }
    Crossing result = at_share(first.share, outer, inner);
    result.source = first.triangle;
    result.normal = surface.normal(first.triangle);
    if (result.normal.dot(outer - inner) < 0.0) {
        result.normal = -result.normal;
    }
    return result;
}

/// The point in which the edge leaves the ball that covers its outer end; the middle of the edge in a pocket.
Crossing at_gap(const NodeStates& states, const Edge& edge) {
    const Lattice& lattice = states.lattice();
    const Vec3 outer = lattice.at(edge.outer);
    const Vec3 ahead = lattice.at(edge.inner) - outer;
    const NodeState* state = states.find(edge.outer);
    const std::array<std::int16_t, 3>& ball = state->to_ball;
    double share = 0.5;
    if (ball != std::array<std::int16_t, 3>{}) {
        const Vec3 from_centre = -0.5 * lattice.side() * Vec3(ball[0], ball[1], ball[2]);
        const double radius = states.surface().tree.nearest(outer - from_centre).distance;
        const double b = from_centre.dot(ahead) / ahead.squaredNorm();
        const double c = (from_centre.squaredNorm() - radius * radius) / ahead.squaredNorm();
        share = -b + std::sqrt(std::max(0.0, b * b - c));
    }
    Crossing result;
    result.point = outer + std::clamp(share, kGapEnds, 1.0 - kGapEnds) * ahead;
    return result;
}

Crossing crossing_of(const NodeStates& states, const Edge& edge) {
    const Lattice& lattice = states.lattice();
    const Vec3 outer = states.position(edge.outer);
    const Vec3 inner = states.position(edge.inner);
    const NodeState* inner_state = states.find(edge.inner);
    if (inner_state != nullptr && inner_state->sheet) {
        return at_sheet(states.surface(), outer, inner, 0.5 * lattice.side());
    }
    // Edges of larger cubes pass through the input.
    const int step = Lattice::step_between(edge.outer, edge.inner);
    if (step < 0 || states.is_barred(edge.outer, step)) {
        return at_input(states.surface(), outer, inner);
    }
    return at_gap(states, edge);
}

/// Moves the crossings that close gaps along their edges towards the middle of their neighbours. A crossing may be
/// anywhere on its edge, so the surface stays sound.
void smooth_gaps(CrossedCells& cells, const std::vector<Edge>& edges, const Lattice& lattice, Progress& progress) {
    const auto closes_gap = [&](std::int32_t k) { return cells.crossings[static_cast<std::size_t>(k)].source < 0; };
    std::vector<const CrossedCell*> at_gaps;
    for (const CrossedCell& cell : cells.cells) {
        if (std::any_of(cell.crossings.begin(), cell.crossings.begin() + cell.polygon.count, closes_gap)) {
            at_gaps.push_back(&cell);
        }
    }
    std::vector<std::int32_t> gaps;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(edges.size()); ++k) {
        if (closes_gap(k)) {
            gaps.push_back(k);
        }
    }
    std::vector<Vec3> sums(cells.crossings.size());
    std::vector<int> counts(cells.crossings.size());
    for (int round = 0; round < WrapTuning::kSmoothing; ++round) {
        for (const std::int32_t k : gaps) {
            sums[k] = Vec3::Zero();
            counts[k] = 0;
        }
        progress.check();
        progress.advance(0.6 + 0.4 * round / WrapTuning::kSmoothing);
        for (const CrossedCell* cell : at_gaps) {
            for (int k = 0; k < cell->polygon.count; ++k) {
                const std::int32_t a = cell->crossings[static_cast<std::size_t>(k)];
                const std::int32_t b = cell->crossings[static_cast<std::size_t>((k + 1) % cell->polygon.count)];
                sums[a] += cells.crossings[b].point;
                sums[b] += cells.crossings[a].point;
                ++counts[a];
                ++counts[b];
            }
        }
        for (const std::int32_t k : gaps) {
            const Vec3 outer = lattice.at(edges[k].outer);
            const Vec3 ahead = lattice.at(edges[k].inner) - outer;
            const double share = (sums[k] / counts[k] - outer).dot(ahead) / ahead.squaredNorm();
            cells.crossings[k].point = outer + std::clamp(share, kGapEnds, 1.0 - kGapEnds) * ahead;
        }
    }
}

}  // namespace

CrossedCells find_crossings(const NodeStates& states, const std::vector<std::int32_t>& patch, Progress& progress) {
    CrossedCells result;
    CellSearch search(states);
    search.run(GradedCells(states, patch, progress), result, progress);
    result.crossings.resize(search.edges.size());
    for_chunks(static_cast<int>(search.edges.size()), [&](int k) {
        result.crossings[static_cast<std::size_t>(k)] = crossing_of(states, search.edges[static_cast<std::size_t>(k)]);
    });
    smooth_gaps(result, search.edges, states.lattice(), progress);
    return result;
}

}  // namespace mq::wrap
