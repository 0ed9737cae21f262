// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "triangulate/edges/edge_discretisation.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Corners of the mesh that the shape does not have, as nodes or edges that are separate in the shape count as one
/// there (geometry::Joined, and edges contracted to a vertex).
class JoinedCorners {
  public:
    JoinedCorners(const Workspace& work, const EdgeDiscretisation& chains);

    /// The entities that count as one at a vertex.
    struct Found {
        geometry::Joined joined;
        double
            own;  ///< radians: the smallest corner in the shape of the faces at the vertex; half a turn: none has one
    };
    /// Returns the entities farthest apart that count as one at a vertex, and the smallest corner of these faces of the
    /// topology, or of all faces there if none are given. No value where nothing is joined.
    std::optional<Found> at(int vertex, std::vector<int> faces = {});

    /// Two segments that meet at a vertex, and the angle between them, radians.
    struct Meeting {
        double angle;
        std::array<int, 2> segments;
    };
    /// Returns the segments that meet at the smallest angle over a face at a vertex where entities count as one; null
    /// where none do.
    const Meeting* narrowest(int vertex);

  private:
    double own_corner(int face, int node);

    const Workspace& work_;
    std::map<int, std::vector<geometry::Joined>> joined_;  // by the node of the vertex
    std::map<int, std::set<int>> nodes_;                   // the nodes of the shape there
    std::map<int, std::set<int>> faces_;                   // the faces there
    std::optional<std::map<int, Meeting>> meetings_;       // by vertex
    std::map<std::pair<int, int>, double> corners_;        // by face and node, radians
};

}  // namespace mq::triangulate
