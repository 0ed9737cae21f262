// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "boolean/exact/exact_point.h"
#include "mesh/corner_table.h"

namespace mq::boolean {

/// The line of a constraint within its plane: either an edge between two given points, or the cut by another plane.
struct Line {
    bool edge = false;
    Vec3 from = Vec3::Zero();  ///< ends, for an edge
    Vec3 to = Vec3::Zero();
    PlanePoints plane;  ///< the other plane, for a cut
};

/// A triangulation of exact points of one plane in which given segments become edges. Segments may cross: the crossing
/// becomes a point. Topology and predicates are exact; the plane is seen along one of the axes.
class ExactConstrainedTriangulation {
  public:
    /// A plane that thousands of others cut takes long: every function looks for a cancellation.
    /// @param plane the plane's points, seen along `axis`
    /// @param turn -1 when the plane's triangles then run clockwise
    ExactConstrainedTriangulation(const PlanePoints& plane, int axis, int turn, const Progress* progress = nullptr)
        : plane_(plane), axis_(axis), turn_(turn), progress_(progress) {}

    /// Adds a point without a place in the triangulation yet; returns its index here.
    int add_point(ExactPoint point);
    /// Begins with one triangle, which runs counter-clockwise.
    void start(int a, int b, int c);
    /// Puts a point on the edge from a to b, in its inside.
    void split_edge(int a, int b, int point);
    /// Inserts a point, and swaps edges around it that are no constraints where that enlarges the smallest angle, so
    /// that vertices have few edges and walks are short. Returns the point, or the one that was in its place.
    int insert(int point);
    /// Makes the segment from a to b a chain of edges; points on it divide it.
    void constrain(int a, int b, int line);
    int add_line(const Line& line);

    /// Swaps edges that are no constraints where that enlarges the smallest angle.
    void improve();

    /// Triangles of point indices, counter-clockwise.
    std::vector<std::array<int, 3>> triangles() const;
    const std::vector<ExactPoint>& points() const { return points_; }
    /// Whether a point lies in the closed triangle a, b, c (counter-clockwise).
    bool in_triangle(int point, int a, int b, int c) const;

  private:
    /// A place on the way of a segment: half-edge h = 3 t + k runs from corner k of triangle t.
    struct Crossing {
        int half_edge = -1;  ///< the half-edge that is crossed; -1: the segment passes through `vertex`
        int vertex = -1;
    };

    static int next(int h) { return mesh::next_corner(h); }
    static int prev(int h) { return mesh::previous_corner(h); }
    int origin(int h) const { return corner_[static_cast<std::size_t>(h)]; }
    int target(int h) const { return origin(next(h)); }
    int apex(int h) const { return origin(prev(h)); }
    int twin(int h) const { return twin_[static_cast<std::size_t>(h)]; }
    int line(int h) const { return line_[static_cast<std::size_t>(h)]; }
    void link(int h, int other);
    void set_line(int h, int value);
    void set_triangle(int t, int a, int b, int c);
    int new_triangle(int a, int b, int c);
    int orient(int a, int b, int c) const;
    /// The half-edge from a to b, or -1.
    int find(int a, int b) const;
    template <typename Visit>
    void around(int vertex, Visit&& visit) const;
    /// A segment that becomes a chain of edges, and how far it has come.
    struct Segment {
        int from = -1;
        int to = -1;
        int line = -1;
        int before = -1;  ///< the point before `at`; -1: there is none yet
        int at = -1;
    };
    int side(const Segment& segment, int point) const;
    Crossing leave(const Segment& segment) const;
    bool ahead(int a, int b, int c) const;
    int step(const Segment& segment);
    void clear_way(const Segment& segment, int end, const std::vector<std::array<int, 2>>& crossed);
    int place(int point);
    void improve_around(int point);
    bool flippable(int h) const;
    void flip(int h);
    int split_at_crossing(int h, int line);
    void split(int h, int point);
    void split_triangle(int t, int point);
    bool better_flipped(int h) const;

    PlanePoints plane_;
    int axis_;
    int turn_;
    const Progress* progress_;
    std::vector<ExactPoint> points_;
    std::vector<int> out_;     ///< one outgoing half-edge for each point, -1 when it is not placed
    std::vector<int> corner_;  ///< by half-edge
    std::vector<int> twin_;
    std::vector<int> line_;
    std::vector<Line> lines_;
};

}  // namespace mq::boolean
