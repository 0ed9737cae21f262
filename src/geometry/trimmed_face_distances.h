// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "base/vec.h"
#include "geometry/session.h"

namespace mq::geometry {

/// Distances of points from trimmed faces with their edges: from the nearest point of the surface if that is inside of
/// the face, else from the nearest point of the edges. Upper bounds, too large only where the search for a nearest
/// point ends in another minimum.
class TrimmedFaceDistances {
  public:
    struct Place {
        int face = -1;
        Vec3 point = Vec3::Zero();
        std::optional<Vec2> guess{};  ///< (u, v) near the nearest point; none: the whole face is searched
    };

    /// @param session  outlives it
    explicit TrimmedFaceDistances(Session& session) : session_(session) {}

    /// Returns the distance of each place, mm; negative if the surface has no nearest point and the face no edges.
    /// @throws Cancelled
    std::vector<double> measure(const std::vector<Place>& places);

  private:
    /// A piece of an edge between two parameters.
    struct Piece {
        int edge = -1;
        double low = 0.0;
        double high = 0.0;
        Vec3 from = Vec3::Zero();
        Vec3 to = Vec3::Zero();
    };
    void divide_edges_of(int face);
    double distance(Answerer& answerer, const Place& place) const;

    Session& session_;
    std::map<int, std::vector<Piece>> pieces_;  ///< by face
};

}  // namespace mq::geometry
