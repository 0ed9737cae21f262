// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "triangulate/disc.h"
#include "triangulate/patches.h"
#include "triangulate/sizing.h"

namespace mq::triangulate {

/// Takes out vertices that released edges left over, and on from there those around, where the angles reach the bound
/// without them: the size that the edges forced goes away. Discs may lie on several faces of a patch.
///
/// What a change must keep: the tolerance, measured both ways: to the faces near it, and from points of the part under
/// what was there (without a tolerance, the distances that were there), alignment with the faces, bounds on lengths,
/// locked vertices.
class PatchCoarsener {
  public:
    PatchCoarsener(Workspace& work, double min_angle_degrees, const Sizing& sizing, Patches& patches);

    /// Leaves no triangle that is gone.
    void run();

  private:
    void find_half_edges();
    double shortest_spoke(int vertex) const;
    bool take_out(int vertex, std::vector<int>& around);
    bool admissible(const Disc& disc) const;
    std::vector<Passenger> passengers(const Disc& disc) const;
    bool near_surface(const Disc& disc, const Vec3& apex, int apex_site) const;
    bool near_passengers(const Disc& disc, const Vec3& apex, int apex_site, const std::vector<Passenger>& passengers,
                         double allowed) const;
    void replace(const Disc& disc, int apex_site);

    Workspace& work_;
    double bound_;  // radians
    const Sizing& sizing_;
    Patches& patches_;
    std::vector<int> half_edge_of_;  // that leaves the vertex; -1: it is gone
};

}  // namespace mq::triangulate
