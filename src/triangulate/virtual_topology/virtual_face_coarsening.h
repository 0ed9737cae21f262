// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/operators/cavity.h"
#include "triangulate/virtual_topology/virtual_faces.h"
#include "triangulate/work_mesh/size_bounds.h"

namespace mq::triangulate {

/// Removes vertices left on removed smooth edges, and from there on those around them, where the angles reach the
/// bound without them: the small triangles that the edges required disappear. Discs may lie on several faces of a
/// patch.
///
/// A change must keep: the tolerance, measured from the mesh to the nearby faces and backward from CAD samples of the
/// former triangles (without a tolerance, the former distances), the alignment with the faces, the bounds on lengths,
/// and locked vertices.
class VirtualFaceCoarsening {
  public:
    VirtualFaceCoarsening(Workspace& work, double min_angle_degrees, const Sizing& sizing, VirtualFaces& patches);

    /// Leaves no unused triangle indices.
    void run();

  private:
    void find_half_edges();
    double shortest_spoke(int vertex) const;
    bool take_out(int vertex, std::vector<int>& around);
    bool admissible(const Cavity& disc) const;
    std::vector<CadSample> passengers(const Cavity& disc) const;
    bool near_surface(const Cavity& disc, const Vec3& apex, int apex_site) const;
    bool near_passengers(const Cavity& disc, const Vec3& apex, int apex_site, const std::vector<CadSample>& passengers,
                         double allowed) const;
    void replace(const Cavity& disc, int apex_site);

    Workspace& work_;
    double bound_;  // radians
    const Sizing& sizing_;
    VirtualFaces& patches_;
    std::vector<int> half_edge_of_;  // by vertex: a half-edge that leaves it; -1: it was removed
};

}  // namespace mq::triangulate
