// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "geometry/session.h"
#include "triangulate/uv_outline.h"

namespace mq::triangulate {

/// A face divided into cells, rectangles in (u, v) that are as small in space as the spacing of samples there.
///
/// At first they divide the rectangle around the outline. A cell that is too long is halved across that of u and v
/// along which it is longer in space: neither the parameters nor the border make slivers, of which there would be
/// many. What lies outside of the outline is dropped.
class FaceCells {
  public:
    struct Corner {
        Vec2 uv;
        Vec3 point;      ///< in the part's coordinates, mm
        double spacing;  ///< 0: the surface has no point there, and no cell such a corner
    };
    /// The spacing at a point of the face, from the answer to Query::face_curvatures. More than 0.
    using Spacing = std::function<double(const geometry::Answer&)>;

    /// @param outline  the face's border in (u, v)
    FaceCells(geometry::Session& session, int face, std::vector<Segment2> outline, Spacing spacing);

    /// Halves cells until none is longer than `share` of the least spacing at its corners.
    void divide(double share, const Progress& progress);
    /// Halves the given cells, each once in the list.
    /// @return the numbers of the halves that are not outside; the first half of a cell keeps the cell's number. Of
    ///     cells that cannot be halved: nothing.
    std::vector<std::size_t> halve(const std::vector<std::size_t>& cells);

    /// The numbers of the cells that are not outside; near ones follow each other.
    std::vector<std::size_t> all() const;
    /// Corner 0 to 3, counter-clockwise in (u, v) from the least.
    const Corner& corner(std::size_t cell, int i) const { return corners_[cells_[cell].corners[i]]; }
    /// Those of all cells that lie inside of the outline.
    std::vector<Corner> inner_corners() const;
    double longest_side(std::size_t cell) const;
    double least_spacing(std::size_t cell) const;
    /// The segments of the outline that the cell meets.
    std::vector<Segment2> outline(std::size_t cell) const;
    /// A point of the cell, (u, v), and whether it lies inside of the outline.
    Vec2 reference(std::size_t cell) const { return reference(cells_[cell]); }
    bool inside(std::size_t cell) const { return cells_[cell].inside; }

  private:
    struct Cell {
        std::array<int, 4> corners;
        int list;  // of the segments that it meets; -1: none
        bool inside;
        std::uint8_t depth;  // how often it has been halved
    };
    void make_roots();
    void halve(std::size_t number, const std::array<int, 2>& middles, std::vector<std::size_t>& halves);
    void measure(std::size_t first);
    /// Its larger extent in space along u (0) and along v (1).
    double extent(const Cell& cell, int axis) const;
    int longer_axis(const Cell& cell) const { return extent(cell, 0) >= extent(cell, 1) ? 0 : 1; }
    double side(int a, int b) const { return (corners_[b].point - corners_[a].point).norm(); }
    Vec2 reference(const Cell& cell) const;
    Triangle2 triangle(const Cell& cell, int half) const;
    bool outside(const Cell& cell) const { return cell.list < 0 && !cell.inside; }
    void place(Cell& cell, const std::vector<int>& among, const Vec2& known, bool inside);

    geometry::Session& session_;
    int face_;
    std::vector<Segment2> outline_;
    Vec2 low_ = Vec2::Zero();  // of the outline
    Vec2 high_ = Vec2::Zero();
    Spacing spacing_;
    std::vector<Corner> corners_;
    std::vector<Cell> cells_;
    std::vector<std::vector<int>> lists_;  // of segments
};

}  // namespace mq::triangulate
