// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/progress.h"
#include "geometry/session.h"
#include "triangulate/spacing/uv_outline.h"

namespace mq::triangulate {

/// A face divided into cells, rectangles in (u, v) that are as small in space as the spacing of samples there.
///
/// At first they divide the rectangle around the outline. A cell that is too long is halved across the parameter along
/// which it is longer in space, so that neither the parameters nor the border cause slivers, of which there would be
/// many. Cells outside of the outline are dropped.
class FaceCells {
  public:
    struct Corner {
        Vec2 uv;
        Vec3 point;      ///< in the shape's coordinates, mm
        double spacing;  ///< mm; 0: the surface has no point there, and the corner belongs to no cell
    };
    /// Returns the spacing at a point of the face, more than 0 mm, from the answer to Query::face_curvatures.
    using Spacing = std::function<double(const geometry::Answer&)>;

    /// @param outline  the face's border in (u, v)
    FaceCells(geometry::Session& session, int face, std::vector<Segment2> outline, Spacing spacing);

    /// Halves cells until none is longer than the fraction `share` of the least spacing at its corners.
    void divide(double share, const Progress& progress);
    /// Halves the given cells, each of which occurs once.
    /// @return the numbers of the halves that are not outside; the first half of a cell keeps the cell's number. Cells
    /// that cannot be halved are omitted.
    std::vector<std::size_t> halve(const std::vector<std::size_t>& cells);

    /// Returns the numbers of the cells that are not outside; neighbouring cells are close to each other in the list.
    std::vector<std::size_t> all() const;
    /// Returns corner 0 to 3, counter-clockwise in (u, v) from the one with the least parameters.
    const Corner& corner(std::size_t cell, int i) const { return corners_[cells_[cell].corners[i]]; }
    /// Returns the corners of all cells that lie inside of the outline.
    std::vector<Corner> inner_corners() const;
    double longest_side(std::size_t cell) const;
    double least_spacing(std::size_t cell) const;
    /// Returns the segments of the outline that the cell meets.
    std::vector<Segment2> outline(std::size_t cell) const;
    /// Returns (u, v) of a point of the cell; `inside` tells whether it lies inside of the outline.
    Vec2 reference(std::size_t cell) const { return reference(cells_[cell]); }
    bool inside(std::size_t cell) const { return cells_[cell].inside; }

  private:
    struct Cell {
        std::array<int, 4> corners;
        int list;  // index into lists_ of the segments that it meets; -1: none
        bool inside;
        std::uint8_t depth;  // number of halvings that led to it
    };
    void make_roots();
    void halve(std::size_t number, const std::array<int, 2>& middles, std::vector<std::size_t>& halves);
    void measure(std::size_t first);
    /// Returns its larger extent in space along u (0) or along v (1), mm.
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
    Vec2 low_ = Vec2::Zero();  // lower corner of the box around the outline, in (u, v)
    Vec2 high_ = Vec2::Zero();
    Spacing spacing_;
    std::vector<Corner> corners_;
    std::vector<Cell> cells_;
    std::vector<std::vector<int>> lists_;  // lists of segments
};

}  // namespace mq::triangulate
