// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>

#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Corners of the part where two edges part so slowly that beside them no triangles have the angles asked for, however
/// the edges are split.
///
/// A piece of an edge whose neighbour across the face is the distance d away is 2 d / tan(bound) long at most, or its
/// triangle is too flat. The innermost piece, up to the distance s from the corner, has none: its triangle reaches into
/// the corner. So where it ends lengths change by s tan(bound) / 2 d at least, and on the face at the other side of the
/// edge triangles in half a turn have to bridge that: each makes the sides at its corner at most so many times longer.
class CornerForce {
  public:
    /// @param bound radians
    CornerForce(const Workspace& work, double bound) : work_(work), bound_(bound) {}

    /// The angle, radians, of such a corner at a vertex that is a CAD node; no value: there is none that is proven.
    std::optional<double> at(int vertex);

  private:
    /// An edge as it leaves the node.
    struct Way {
        int edge = -1;
        int end = 0;  ///< 0: where its parameters begin
    };
    std::optional<double> find(int vertex) const;
    std::vector<Vec3> points_on(const Way& way) const;
    double least_step(const Way& way, const Way& other) const;

    const Workspace& work_;
    double bound_;
    std::map<int, std::optional<double>> found_;  // by vertex
};

}  // namespace mq::triangulate
