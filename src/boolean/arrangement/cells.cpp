// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/cells.h"

#include <algorithm>
#include <optional>
#include <queue>

#include "base/disjoint_sets.h"
#include "base/error.h"
#include "boolean/arrangement/radial_order.h"
#include "boolean/arrangement/ray_winding.h"
#include "boolean/input/operand_repair.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/edge_table.h"

namespace mq::boolean {

namespace {

using Sets = DisjointSets<std::int32_t>;

/// Adds to the windings of an operand.
void add(Windings& windings, std::int32_t operand, std::int32_t times) {
    const auto place = std::lower_bound(windings.begin(), windings.end(), operand,
                                        [](const Winding& w, std::int32_t o) { return w.operand < o; });
    if (place == windings.end() || place->operand != operand) {
        windings.insert(place, {operand, times});
    } else if ((place->times += times) == 0) {
        windings.erase(place);
    }
}

/// The first operand of which the windings differ.
std::int32_t first_difference(const Windings& a, const Windings& b) {
    const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return x == a.end() ? y->operand : (y == b.end() ? x->operand : std::min(x->operand, y->operand));
}

/// An edge where patches meet: its faces are found at [first, last) of a list.
struct CurveEdge {
    std::int32_t low;
    std::int32_t high;
    std::size_t first;
    std::size_t last;
};

class CellFinder {
  public:
    CellFinder(const Soup& soup, const Arrangement& arrangement, const Progress& progress)
        : soup_(soup), arrangement_(arrangement), progress_(progress) {}

    Cells run() {
        find_patches();
        progress_.check();
        find_sides();
        progress_.check();
        propagate_windings();
        std::vector<std::vector<std::int32_t>> faces(static_cast<std::size_t>(components_));
        for (std::size_t f = 0; f < patch_.size(); ++f) {
            faces[static_cast<std::size_t>(body_[static_cast<std::size_t>(patch_[f])])].push_back(
                static_cast<std::int32_t>(f));
        }
        for (std::int32_t component = 0; component < components_; ++component) {
            progress_.check();
            assign_windings(component, faces[static_cast<std::size_t>(component)]);
        }
        return std::move(cells_);
    }

  private:
    /// Patches are faces joined across edges that have exactly two.
    void find_patches() {
        std::vector<Triangle> triangles;
        triangles.reserve(arrangement_.faces.size());
        for (const Face& face : arrangement_.faces) {
            triangles.push_back(face.points);
        }
        const mesh::EdgeTable table(triangles, static_cast<std::size_t>(arrangement_.points.size()));
        Sets sets(triangles.size());
        table.for_each([&](std::int32_t low, std::int32_t high, const std::uint32_t* first, const std::uint32_t* last) {
            if (last - first == 1) {
                throw TopologyError(phrases::kEdgeNotClosed, {{"point", in_mm(arrangement_.points.approx(low), 6)}});
            }
            if (last - first == 2 && runs_up(first[0], low) != runs_up(first[1], low)) {
                sets.unite(static_cast<std::int32_t>(first[0] / 3), static_cast<std::int32_t>(first[1] / 3));
                return;
            }
            curve_.push_back({low, high, corners_.size(), corners_.size() + static_cast<std::size_t>(last - first)});
            corners_.insert(corners_.end(), first, last);
        });
        std::int32_t count = 0;
        patch_ = sets.number(count);
        cells_.patches = static_cast<std::size_t>(count);
        cells_.curve_edges = curve_.size();
    }

    /// Whether the directed edge of a corner starts at `low`.
    bool runs_up(std::uint32_t corner, std::int32_t low) const {
        return arrangement_.faces[corner / 3].points[corner % 3] == low;
    }

    /// Sides of patches are in one cell where they face each other across an edge. Side 2 p is the front of patch p.
    void find_sides() {
        Sets sides(2 * cells_.patches);
        Sets bodies(cells_.patches);
        std::vector<RadialFace> around;
        for (const CurveEdge& edge : curve_) {
            around.clear();
            for (std::size_t i = edge.first; i < edge.last; ++i) {
                const std::uint32_t c = corners_[i];
                const std::int32_t apex = arrangement_.faces[c / 3].points[(c % 3 + 2) % 3];
                around.push_back(
                    {static_cast<std::int32_t>(c / 3), apex, runs_up(c, edge.low), arrangement_.faces[c / 3].source});
            }
            sort_radially(arrangement_.points, edge.low, edge.high, around);
            for (std::size_t i = 0; i < around.size(); ++i) {
                const RadialFace& one = around[i];
                const RadialFace& two = around[(i + 1) % around.size()];
                const std::int32_t p = patch_[static_cast<std::size_t>(one.face)];
                const std::int32_t q = patch_[static_cast<std::size_t>(two.face)];
                sides.unite(2 * p + (one.runs_up ? 0 : 1), 2 * q + (two.runs_up ? 1 : 0));
                bodies.unite(p, q);
            }
        }
        std::int32_t cells = 0;
        side_cell_ = sides.number(cells);
        cells_.windings.resize(static_cast<std::size_t>(cells));
        body_ = bodies.number(components_);
        cells_.front.resize(patch_.size());
        cells_.back.resize(patch_.size());
        for (std::size_t f = 0; f < patch_.size(); ++f) {
            cells_.front[f] = side_cell_[static_cast<std::size_t>(2 * patch_[f])];
            cells_.back[f] = side_cell_[static_cast<std::size_t>(2 * patch_[f] + 1)];
        }
    }

    Windings& windings(std::int32_t cell) { return cells_.windings[static_cast<std::size_t>(cell)]; }

    /// Adds the change of each operand's winding number on passing a face from its front to its back, times `sign`.
    void add_jump(const Face& face, int sign, Windings& windings) const {
        const auto pass = [&](const CoplanarCover& cover) {
            add(windings, soup_.source[static_cast<std::size_t>(cover.triangle)].operand, sign * cover.turn);
        };
        if (face.stack < 0) {
            pass({face.source, 1});
        } else {
            const std::vector<CoplanarCover>& stack = arrangement_.stacks[static_cast<std::size_t>(face.stack)];
            std::for_each(stack.begin(), stack.end(), pass);
        }
    }

    /// Computes the windings of all cells relative to one cell of each component.
    void propagate_windings() {
        std::vector<std::int32_t> face_of(cells_.patches, -1);
        for (std::size_t f = 0; f < patch_.size(); ++f) {
            face_of[static_cast<std::size_t>(patch_[f])] = static_cast<std::int32_t>(f);
        }
        const std::size_t cells = cells_.windings.size();
        std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>> beside(cells);  // (patch, cell beyond)
        for (std::size_t p = 0; p < cells_.patches; ++p) {
            const std::int32_t front = side_cell_[2 * p];
            const std::int32_t back = side_cell_[2 * p + 1];
            beside[static_cast<std::size_t>(front)].emplace_back(static_cast<std::int32_t>(p), back);
            beside[static_cast<std::size_t>(back)].emplace_back(static_cast<std::int32_t>(p), front);
        }
        std::vector<char> known(cells, 0);
        component_cells_.resize(static_cast<std::size_t>(components_));
        for (std::size_t start = 0; start < cells; ++start) {
            if (known[start] != 0) {
                continue;
            }
            known[start] = 1;
            std::queue<std::int32_t> todo;
            todo.push(static_cast<std::int32_t>(start));
            while (!todo.empty()) {
                const std::int32_t cell = todo.front();
                todo.pop();
                for (const auto& [patch, beyond] : beside[static_cast<std::size_t>(cell)]) {
                    pass(cell, patch, beyond, face_of[static_cast<std::size_t>(patch)], known, todo);
                }
                const std::int32_t patch = beside[static_cast<std::size_t>(cell)].front().first;
                component_cells_[static_cast<std::size_t>(body_[static_cast<std::size_t>(patch)])].push_back(cell);
            }
        }
    }

    void pass(std::int32_t cell, std::int32_t patch, std::int32_t beyond, std::int32_t face, std::vector<char>& known,
              std::queue<std::int32_t>& todo) {
        const Face& passed = arrangement_.faces[static_cast<std::size_t>(face)];
        Windings behind = windings(cell);
        add_jump(passed, side_cell_[static_cast<std::size_t>(2 * patch)] == cell ? 1 : -1, behind);
        if (known[static_cast<std::size_t>(beyond)] == 0) {
            windings(beyond) = std::move(behind);
            known[static_cast<std::size_t>(beyond)] = 1;
            todo.push(beyond);
            return;
        }
        if (!(behind == windings(beyond))) {
            const std::int32_t wrong = first_difference(behind, windings(beyond));
            throw TopologyError(
                phrases::kNoVolumeNear,
                {{"name", operand_name(static_cast<std::size_t>(wrong), static_cast<std::size_t>(soup_.operands))},
                 {"point", in_mm(arrangement_.points.approx(passed.points[0]), 6)}});
        }
    }

    /// Makes a component's windings absolute by one ray from its largest face. A component too thin to hold a point of
    /// double precision encloses nothing: all its cells become one.
    void assign_windings(std::int32_t component, const std::vector<std::int32_t>& faces) {
        const std::vector<std::int32_t>& cells = component_cells_[static_cast<std::size_t>(component)];
        const std::optional<RayWinding> found = winding_in_front(soup_, arrangement_, faces);
        if (!found.has_value()) {
            for (const std::int32_t c : cells) {
                windings(c).clear();
            }
            return;
        }
        Windings offset;
        for (std::int32_t k = 0; k < soup_.operands; ++k) {
            if (found->winding[static_cast<std::size_t>(k)] != 0) {
                offset.push_back({k, found->winding[static_cast<std::size_t>(k)]});
            }
        }
        for (const Winding& relative : windings(cells_.front[static_cast<std::size_t>(found->face)])) {
            add(offset, relative.operand, -relative.times);
        }
        for (const std::int32_t c : cells) {
            for (const Winding& more : offset) {
                add(windings(c), more.operand, more.times);
            }
        }
    }

    const Soup& soup_;
    const Arrangement& arrangement_;
    const Progress& progress_;
    Cells cells_;
    std::vector<CurveEdge> curve_;
    std::vector<std::uint32_t> corners_;  ///< corners 3 * face + k of the faces at curve edges
    std::vector<std::int32_t> patch_;     ///< patch of each face
    std::vector<std::int32_t> side_cell_;
    std::vector<std::int32_t> body_;  ///< component of each patch
    std::vector<std::vector<std::int32_t>> component_cells_;
    std::int32_t components_ = 0;
};

}  // namespace

Cells find_cells(const Soup& soup, const Arrangement& arrangement, const Progress& progress) {
    return CellFinder(soup, arrangement, progress).run();
}

}  // namespace mq::boolean
