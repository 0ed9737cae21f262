// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/face_border.h"
#include "triangulate/corner_fan.h"

namespace mq::triangulate {

/// The border of a face as the first front of a triangulation in space, seen from outside: walking along its edges the
/// face lies on the left. Sites of one vertex that a collapsed piece joins (the pole of a sphere) are merged, as they
/// differ in (u, v) alone.
class FrontBorder {
  public:
    struct Edge {
        int from;
        int to;
        int piece;  ///< of the border
    };

    FrontBorder(const geometry::FaceBorder& border, bool reversed);

    const std::vector<Edge>& edges() const { return edges_; }
    bool merged(int site) const { return site < static_cast<int>(root_.size()) && root_[site] != site; }
    /// By site: mean distance to the neighbours along the border, mm.
    const std::vector<double>& scales() const { return scales_; }
    /// Why the border is no front; empty when it is one.
    const std::string& failure() const { return failure_; }
    /// Takes up what lies outside of the face around a site.
    void take_outside(int site, CornerFan& fan) const;
    /// Gives every corner at merged sites the one that is nearest to its triangle in (u, v).
    void part_merged(geometry::FaceTriangulation& face) const;

  private:
    void merge(bool reversed);
    void check_angles();

    const geometry::FaceBorder& border_;
    std::vector<int> root_;  // by site: the one that stands for it
    std::vector<Edge> edges_;
    std::vector<std::vector<int>> before_;  // by site: where edges come from
    std::vector<std::vector<int>> after_;   // and lead to
    std::vector<double> scales_;
    std::string failure_;
};

}  // namespace mq::triangulate
