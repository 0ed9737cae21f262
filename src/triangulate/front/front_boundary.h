// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include "triangulate/front/angular_sectors.h"
#include "triangulate/initial/face_boundary.h"

namespace mq::triangulate {

/// The border of a face as the first front of a triangulation in space, seen from outside: the face lies to the
/// left of every edge. Sites of one vertex that a collapsed piece joins (the pole of a sphere) are merged, since
/// they differ in (u, v) only.
class FrontBorder {
  public:
    struct Edge {
        int from;
        int to;
        int piece;  ///< index into the pieces of the border
    };

    FrontBorder(const FaceBoundary& border, bool reversed);

    const std::vector<Edge>& edges() const { return edges_; }
    bool merged(int site) const { return site < static_cast<int>(root_.size()) && root_[site] != site; }
    /// By site: the mean distance in mm to the neighbours along the border.
    const std::vector<double>& scales() const { return scales_; }
    /// The reason why the border cannot be a front; empty if it can.
    const std::string& failure() const { return failure_; }
    /// Marks the sectors outside of the face around a site as occupied.
    void occupy_outside(int site, AngularSectors& fan) const;
    /// Replaces a merged site in every triangle by that one of its images which is nearest to the triangle in (u, v).
    void part_merged(FaceMesh& face) const;

  private:
    void merge(bool reversed);
    void check_angles();

    const FaceBoundary& border_;
    std::vector<int> root_;  // by site: its representative among the merged sites
    std::vector<Edge> edges_;
    std::vector<std::vector<int>> before_;  // by site: the origins of the edges that end there
    std::vector<std::vector<int>> after_;   // by site: the ends of the edges that begin there
    std::vector<double> scales_;
    std::string failure_;
};

}  // namespace mq::triangulate
