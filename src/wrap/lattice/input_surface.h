// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "mesh/proof/distance_bounds.h"
#include "mesh/triangle_mesh.h"

namespace mq::wrap {

/// The point in which a segment first meets a surface.
struct FirstMeeting {
    double share = 2.0;  ///< fraction of the segment from its start; above 1: it meets nothing
    std::int32_t triangle = -1;
};

/// Segments from one point.
struct Fan {
    static constexpr std::size_t kMostSegments = 7;
    Vec3 from = Vec3::Zero();
    std::array<Vec3, kMostSegments> to{};  ///< the first `count` of them
    std::size_t count = 0;
};

/// The triangles to be wrapped, in any order and orientation, and the queries that the wrap makes. Triangles are closed
/// sets: a segment that touches an edge or a vertex meets them, so that none passes between neighbours. Queries are
/// exact.
class InputSurface : public mesh::SearchedSurface {
  public:
    using SearchedSurface::SearchedSurface;

    bool meets(const Vec3& from, const Vec3& to) const;
    /// Bit k: segment k of a fan meets the surface.
    unsigned met_of(const Fan& fan) const;
    FirstMeeting first_meeting(const Vec3& from, const Vec3& to) const;
    /// The normal of length 1; zero for a triangle without area.
    Vec3 normal(std::int32_t triangle) const;
};

}  // namespace mq::wrap
