// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>

#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Corners of the shape where two edges separate so slowly that no triangles beside them reach the angle bound,
/// however the edges are split.
///
/// A piece of an edge whose neighbour across the face is at the distance d is at most 2 d / tan(bound) long, or its
/// triangle is too flat. The innermost piece, up to the distance s from the corner, has no such limit: its triangle
/// reaches into the corner. So at its end lengths change by at least s tan(bound) / 2 d, and on the face at the other
/// side of the edge triangles within half a turn have to bridge this ratio, of which each can contribute a bounded
/// factor.
class InfeasibleCorner {
  public:
    /// @param bound radians
    InfeasibleCorner(const Workspace& work, double bound) : work_(work), bound_(bound) {}

    /// Returns the angle, radians, of such a corner at a vertex that is a CAD node; no value if none is proven.
    std::optional<double> at(int vertex);

  private:
    /// An edge, directed away from the node.
    struct Way {
        int edge = -1;
        int end = 0;  ///< 0: the node is where its parameters begin
    };
    std::optional<double> find(int vertex) const;
    std::vector<Vec3> points_on(const Way& way) const;
    double least_step(const Way& way, const Way& other) const;

    const Workspace& work_;
    double bound_;
    std::map<int, std::optional<double>> found_;  // by vertex
};

}  // namespace mq::triangulate
