// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Coordinates in which the boxes of a mesh's long, thin triangles are thin.
///
/// Tessellated CAD models have needles in two or three directions at right angles. If the model was turned, the
/// axis-parallel boxes of n needles meet in about n^2 pairs, although the needles do not; boxes along the needles' own
/// directions meet in about n pairs. A mesh with few needles keeps its coordinates.
class NeedleFrame {
  public:
    /// The vertices are referred to: they must outlive the frame. 10 us, and 10 ns a vertex where the frame is turned.
    NeedleFrame(const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles);
    /// A place in this frame.
    Vec3 turned(const Vec3& p) const { return slack_ > 0.0 ? Vec3(frame_ * p) : p; }
    /// Adds a vertex that was appended to the mesh's vertices; it must not be farther from the origin than those
    /// before.
    void add(const Vec3& vertex);

    /// The vertices in this frame; the mesh's own vertices if the frame is not turned.
    const std::vector<Vec3>& vertices() const { return slack_ > 0.0 ? turned_ : vertices_; }
    /// A bound for the rounding error of coordinates in this frame, mm.
    double slack() const { return slack_; }

  private:
    const std::vector<Vec3>& vertices_;
    std::vector<Vec3> turned_;
    Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
    double slack_ = 0.0;
};

}  // namespace mq::mesh
