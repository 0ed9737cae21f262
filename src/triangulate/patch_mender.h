// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>
#include <vector>

#include "triangulate/mender.h"
#include "triangulate/patches.h"

namespace mq::triangulate {

/// Mends and coarsens patches of faces: discs may lie on several of them.
///
/// What a change must keep: the tolerance, measured both ways: to the faces near it, and from points of the part under
/// what was there (without a tolerance, the distances that were there), alignment with the faces, bounds on lengths,
/// locked vertices.
class PatchMender : public Mender {
  public:
    PatchMender(Workspace& work, double min_angle_degrees, const Sizing& sizing, Patches& patches);

    /// Takes out vertices that released edges left over, and on from there those around, where the angles reach the
    /// bound without them: the size that the edges forced goes away.
    /// Leaves no triangle that is gone.
    void coarsen();

  private:
    bool admissible(const Disc& disc) const override;
    bool near_surface(const Disc& disc, const Corner& apex, const Vec2& uv, int apex_site) const override;
    std::optional<SurfacePoint> apex_near(const Disc& disc, const Vec3& p) const override;
    int add_apex(const Disc& disc, const SurfacePoint& p) override;
    std::vector<int> exchange(const Disc& disc, int apex_site) override;
    void moved(const std::vector<std::pair<int, int>>& pairs) override;

    void find_half_edges();
    std::vector<Passenger> passengers(const Disc& disc) const;
    bool near_passengers(const Disc& disc, const Vec3& apex, int apex_site, const std::vector<Passenger>& passengers,
                         double allowed) const;
    bool take_out(int vertex, std::vector<int>& around);

    Patches& patches_;
    std::vector<int> half_edge_of_;  // that leaves the vertex; -1: it is gone
    mutable int apex_face_ = -1;     // of the point that apex_near gave last
};

}  // namespace mq::triangulate
