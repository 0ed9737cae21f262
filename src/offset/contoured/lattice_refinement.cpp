// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/lattice_refinement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/key_set.h"
#include "base/parallel.h"
#include "contour/cell_surface.h"
#include "contour/tuning.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "offset/contoured/bisected_lattice.h"
#include "offset/contoured/side_proof.h"
#include "offset/contoured/tuning.h"

namespace mq::offset {

namespace {

using contour::CellSurface;
using contour::CrossedCell;
using contour::Crossing;
using contour::LevelSample;

class Refinement {
  public:
    Refinement(const DistanceLevelSet& level_set, const Box& box, double slack, double finest, const Progress& progress)
        : level_set_(level_set),
          proof_(level_set, slack),
          slack_(slack),
          finest_(finest),
          lattice_(box, box.largest_side() / ContouredOffsetTuning::kCubes, finest),
          progress_(progress) {}

    RefinedCells run() {
        for (std::vector<std::size_t> fresh = next_cells(); !fresh.empty(); fresh = next_cells()) {
            measure_nodes();
            find_crossings(fresh);
            std::vector<Verdict> verdicts(fresh.size());
            for_chunks(static_cast<int>(fresh.size()), [&](int k) {
                progress_.check();
                const auto slot = static_cast<std::size_t>(k);
                verdicts[slot] = verdict_on(lattice_.cell(fresh[slot]));
            });
            for (std::size_t k = 0; k < fresh.size(); ++k) {
                if (!verdicts[k].is_within_slack) {
                    divide(fresh[k], verdicts[k]);
                }
            }
            if (static_cast<double>(lattice_.cell_count()) > ContouredOffsetTuning::kMostCells) {
                throw InvalidInput(phrases::kManyCells,
                                   {{"count", static_cast<long>(ContouredOffsetTuning::kMostCells)}});
            }
        }
        return collected();
    }

  private:
    using Cell = BisectedLattice::Cell;

    /// The undivided cells that were made since the last call.
    std::vector<std::size_t> next_cells() {
        std::vector<std::size_t> fresh;
        for (; known_cells_ < lattice_.cell_count(); ++known_cells_) {
            if (!lattice_.is_divided(known_cells_)) {
                fresh.push_back(known_cells_);
            }
        }
        return fresh;
    }
    /// The decision on a cell: whether to divide it, and at which edge if one is known.
    struct Verdict {
        bool is_within_slack = true;
        std::array<std::int32_t, 2> edge{-1, -1};
        Vec3 place = Vec3::Zero();
    };
    Verdict verdict_on(const Cell& cell) const {
        Verdict result;
        result.is_within_slack = is_within_slack(cell);
        for (std::size_t i = 0; i < 4 && !result.is_within_slack; ++i) {
            for (std::size_t j = 0; j < i && result.edge[0] < 0; ++j) {
                find_feature(std::min(cell[i], cell[j]), std::max(cell[i], cell[j]), result);
            }
        }
        return result;
    }
    /// Finds where the other side reaches across an edge between two nodes on one side: at the intersection of the
    /// planes at both ends. A node there makes an edge of the offset cross each face of a cell once.
    void find_feature(std::int32_t a, std::int32_t b, Verdict& result) const {
        const LevelSample& from = levels_[static_cast<std::size_t>(a)];
        const LevelSample& to = levels_[static_cast<std::size_t>(b)];
        const Vec3 way = lattice_.at(b) - lattice_.at(a);
        if (is_outside(a) != is_outside(b) || way.norm() <= finest_) {
            return;
        }
        const double slope = from.gradient.dot(way) - to.gradient.dot(way);
        const double share = slope == 0.0 ? 0.0 : (to.value - to.gradient.dot(way) - from.value) / slope;
        const double kEnds = ContouredOffsetTuning::kFeatureEnds;
        if (share < kEnds || share > 1.0 - kEnds) {
            return;
        }
        const Vec3 place = lattice_.at(a) + share * way;
        if ((level_set_.at(place, from.source).value >= 0.0) != is_outside(a)) {
            result.edge = {a, b};
            result.place = place;
        }
    }

    void divide(std::size_t cell, const Verdict& verdict) {
        if (lattice_.is_divided(cell)) {
            return;
        }
        if (verdict.edge[0] >= 0) {
            lattice_.divide_edge(verdict.edge[0], verdict.edge[1], verdict.place);
            return;
        }
        if (lattice_.is_divisible(lattice_.cell(cell))) {
            lattice_.divide(cell);
            return;
        }
        // The contour may pass any point of the cell: each node bounds the distance of such points from the offset.
        const Tetrahedron corners = lattice_.corners(lattice_.cell(cell));
        double least = std::numeric_limits<double>::infinity();
        for (const std::int32_t node : lattice_.cell(cell)) {
            double reach = 0.0;
            for (const Vec3& corner : corners) {
                reach = std::max(reach, (corner - lattice_.at(node)).norm());
            }
            least = std::min(least, std::abs(value(node)) + reach);
        }
        bound_ = std::max(bound_, least);
    }

    void measure_nodes() {
        const std::size_t known = levels_.size();
        levels_.resize(lattice_.node_count());
        for_chunks(static_cast<int>(levels_.size() - known), [&](int k) {
            progress_.check();
            const std::size_t node = known + static_cast<std::size_t>(k);
            levels_[node] = level_set_.at(lattice_.at(static_cast<std::int32_t>(node)), -1);
        });
    }
    double value(std::int32_t node) const { return levels_[static_cast<std::size_t>(node)].value; }
    bool is_outside(std::int32_t node) const { return value(node) >= 0.0; }

    void find_crossings(const std::vector<std::size_t>& fresh) {
        std::vector<std::array<std::int32_t, 2>> edges;
        const std::size_t known = crossings_.size();
        for (const std::size_t cell : fresh) {
            const auto& nodes = lattice_.cell(cell);
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    if (is_outside(nodes[i]) != is_outside(nodes[j])) {
                        const auto number = static_cast<std::int32_t>(known + edges.size());
                        if (numbers_.insert({pair_key(nodes[i], nodes[j]), number}).second) {
                            edges.push_back({std::min(nodes[i], nodes[j]), std::max(nodes[i], nodes[j])});
                        }
                    }
                }
            }
        }
        crossings_.resize(known + edges.size());
        for_chunks(static_cast<int>(edges.size()), [&](int k) {
            progress_.check();
            const auto slot = static_cast<std::size_t>(k);
            crossings_[known + slot] = crossing(edges[slot]);
        });
    }

    /// The point of an edge at which the level set is 0: regula falsi with the Illinois rule, then bisection.
    Crossing crossing(const std::array<std::int32_t, 2>& edge) const {
        constexpr int kTrials = 40;
        constexpr int kFalsi = 6;
        const auto [inner, outer] = is_outside(edge[0]) ? std::pair(edge[1], edge[0]) : std::pair(edge[0], edge[1]);
        const Vec3 from = lattice_.at(inner);
        const Vec3 way = lattice_.at(outer) - from;
        double low = 0.0;
        double high = 1.0;
        double below = value(inner);
        double above = value(outer);
        double share = 0.5;
        int last = 0;
        LevelSample level = levels_[static_cast<std::size_t>(inner)];
        for (int i = 0; i < kTrials; ++i) {
            share = i < kFalsi ? (low * above - high * below) / (above - below) : 0.5 * (low + high);
            level = level_set_.at(from + share * way, level.source);
            if (std::abs(level.value) <= level_set_.resolution()) {
                break;
            }
            const int side = level.value < 0.0 ? -1 : 1;
            (side < 0 ? low : high) = share;
            (side < 0 ? below : above) = level.value;
            if (side == last) {
                (side < 0 ? above : below) *= 0.5;
            }
            last = side;
        }
        const double kEnd = contour::ContourTuning::kEndShare;
        Crossing result;
        result.point = from + std::clamp(share, kEnd, 1.0 - kEnd) * way;
        level = level_set_.at(result.point, level.source);
        result.on_input = result.point - level.value * level.gradient;
        result.normal = level.gradient;
        result.source = level.source;
        result.patch = level_set_.patch(level.source);
        return result;
    }

    CrossedCell crossed(const Cell& cell) const {
        CrossedCell result;
        result.corners = lattice_.corners(cell);
        std::array<bool, 4> outside{};
        for (std::size_t k = 0; k < 4; ++k) {
            outside[k] = is_outside(cell[k]);
        }
        result.polygon = contour::cell_polygon(result.corners, outside);
        for (std::size_t k = 0; k < static_cast<std::size_t>(result.polygon.count); ++k) {
            const auto& ends = result.polygon.edges[k];
            result.crossings[k] =
                numbers_.at(pair_key(cell[static_cast<std::size_t>(ends[0])], cell[static_cast<std::size_t>(ends[1])]));
        }
        return result;
    }

    bool is_within_slack(const Cell& cell) const {
        const CrossedCell here = crossed(cell);
        if (here.polygon.count == 0) {
            const LevelSample& level = levels_[static_cast<std::size_t>(cell[0])];
            return proof_.proves(here.corners, level.value >= 0.0, level.source);
        }
        const CellSurface surface = contour::cell_surface(here, crossings_, &level_set_);
        return is_near(here, surface) && are_sides_proven(cell, here, surface);
    }
    const Crossing& at(const CrossedCell& cell, int k) const {
        return crossings_[static_cast<std::size_t>(cell.crossings[static_cast<std::size_t>(k % cell.polygon.count)])];
    }
    /// Whether some sample points of the surface are within the slack: most cells that are too large fail here.
    bool is_near(const CrossedCell& cell, const CellSurface& surface) const {
        const auto near = [&](const Vec3& p) { return std::abs(level_set_.at(p, at(cell, 0).source).value) <= slack_; };
        if (!near(surface.apex)) {
            return false;
        }
        for (int k = 0; k < cell.polygon.count; ++k) {
            const Vec3& a = at(cell, k).point;
            const Vec3& b = at(cell, k + 1).point;
            const Vec3 between = surface.has_face_point[static_cast<std::size_t>(k)]
                                     ? surface.face_points[static_cast<std::size_t>(k)]
                                     : Vec3(0.5 * (a + b));
            if (!near(between) || !near((surface.apex + a + between) / 3.0) ||
                !near((surface.apex + b + between) / 3.0)) {
                return false;
            }
        }
        return true;
    }

    /// Whether the proof holds for the whole cell: for the cones from the vertex of its surface over the faces of the
    /// cell, on both sides of the polygon.
    bool are_sides_proven(const Cell& cell, const CrossedCell& here, const CellSurface& surface) const {
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            const std::array<std::size_t, 3> face{(opposite + 1) % 4, (opposite + 2) % 4, (opposite + 3) % 4};
            std::array<bool, 3> outside{};
            for (std::size_t k = 0; k < 3; ++k) {
                outside[k] = is_outside(cell[face[k]]);
            }
            const auto count = std::count(outside.begin(), outside.end(), true);
            if (count == 0 || count == 3) {
                if (!cone_holds(surface.apex, {here.corners[face[0]], here.corners[face[1]], here.corners[face[2]]},
                                count == 3, at(here, 0).source)) {
                    return false;
                }
                continue;
            }
            std::size_t lone = 0;  // the only corner on its side
            while (outside[lone] != (count == 1)) {
                ++lone;
            }
            if (!divided_face_holds(cell, here, surface, {face[lone], face[(lone + 1) % 3], face[(lone + 2) % 3]},
                                    count == 1)) {
                return false;
            }
        }
        return true;
    }
    bool cone_holds(const Vec3& apex, const std::array<Vec3, 3>& base, bool outside, std::int32_t guess) const {
        // The tip of a fan lies on some of the faces; a tetrahedron that is flatter than this is covered by those
        // beside it.
        const double flat = 1e-6 * slack_;
        const double height = (base[0] - apex).cross(base[1] - apex).dot(base[2] - apex);
        double longest = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            longest = std::max({longest, (base[k] - apex).norm(), (base[k] - base[(k + 1) % 3]).norm()});
        }
        return std::abs(height) <= flat * longest * longest ||
               proof_.proves({apex, base[0], base[1], base[2]}, outside, guess);
    }
    /// @param face  its corners; the first one is alone on its side
    bool divided_face_holds(const Cell& cell, const CrossedCell& here, const CellSurface& surface,
                            const std::array<std::size_t, 3>& face, bool lone_outside) const {
        const auto crossing_to = [&](std::size_t corner) { return numbers_.at(pair_key(cell[face[0]], cell[corner])); };
        const std::int32_t first = crossing_to(face[1]);
        const std::int32_t second = crossing_to(face[2]);
        const Vec3& b = crossings_[static_cast<std::size_t>(first)].point;
        const Vec3& c = crossings_[static_cast<std::size_t>(second)].point;
        const Vec3* point = nullptr;
        for (int k = 0; k < here.polygon.count; ++k) {
            const std::int32_t from = here.crossings[static_cast<std::size_t>(k)];
            const std::int32_t to = here.crossings[static_cast<std::size_t>((k + 1) % here.polygon.count)];
            if (surface.has_face_point[static_cast<std::size_t>(k)] && pair_key(from, to) == pair_key(first, second)) {
                point = &surface.face_points[static_cast<std::size_t>(k)];
            }
        }
        const Vec3& lone = here.corners[face[0]];
        const Vec3& u = here.corners[face[1]];
        const Vec3& v = here.corners[face[2]];
        const auto holds = [&](const Vec3& p, const Vec3& q, const Vec3& r, bool outside) {
            return cone_holds(surface.apex, {p, q, r}, outside, crossings_[static_cast<std::size_t>(first)].source);
        };
        if (point == nullptr) {
            return holds(lone, b, c, lone_outside) && holds(b, u, v, !lone_outside) && holds(b, v, c, !lone_outside);
        }
        return holds(lone, b, *point, lone_outside) && holds(lone, *point, c, lone_outside) &&
               holds(*point, b, u, !lone_outside) && holds(*point, u, v, !lone_outside) &&
               holds(*point, v, c, !lone_outside);
    }

    RefinedCells collected() {
        RefinedCells result;
        result.bound = std::max(slack_, bound_);
        std::vector<char> taken(lattice_.node_count());
        for (std::size_t k = 0; k < lattice_.cell_count(); ++k) {
            if (lattice_.is_divided(k)) {
                continue;
            }
            const CrossedCell cell = crossed(lattice_.cell(k));
            if (cell.polygon.count == 0) {
                continue;
            }
            for (const std::int32_t node : lattice_.cell(k)) {
                if (taken[static_cast<std::size_t>(node)] == 0) {
                    taken[static_cast<std::size_t>(node)] = 1;
                    result.nodes.push_back({lattice_.at(node), value(node)});
                }
            }
            result.crossed.cells.push_back(cell);
        }
        keep_used_crossings(result.crossed);
        return result;
    }
    /// Removes crossings of divided edges, which no cell uses any more. The others keep their order, on which points on
    /// faces depend.
    void keep_used_crossings(contour::CrossedCells& result) const {
        std::vector<std::int32_t> number(crossings_.size(), -1);
        for (const CrossedCell& cell : result.cells) {
            for (std::size_t k = 0; k < static_cast<std::size_t>(cell.polygon.count); ++k) {
                number[static_cast<std::size_t>(cell.crossings[k])] = 0;
            }
        }
        for (std::size_t k = 0; k < crossings_.size(); ++k) {
            if (number[k] == 0) {
                number[k] = static_cast<std::int32_t>(result.crossings.size());
                result.crossings.push_back(crossings_[k]);
            }
        }
        for (CrossedCell& cell : result.cells) {
            for (std::size_t k = 0; k < static_cast<std::size_t>(cell.polygon.count); ++k) {
                cell.crossings[k] = number[static_cast<std::size_t>(cell.crossings[k])];
            }
        }
    }

    const DistanceLevelSet& level_set_;
    const SideProof proof_;
    const double slack_;
    const double finest_;
    BisectedLattice lattice_;
    const Progress& progress_;
    std::size_t known_cells_ = 0;
    double bound_ = 0.0;
    std::vector<LevelSample> levels_;  ///< by node
    KeyMap<std::int32_t> numbers_;     ///< indices of crossings, by edge
    std::vector<Crossing> crossings_;
};

}  // namespace

RefinedCells refine(const DistanceLevelSet& level_set, const Box& box, double slack, double finest,
                    const Progress& progress) {
    return Refinement(level_set, box, slack, finest, progress).run();
}

}  // namespace mq::offset
