// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include "geometry/topology.h"
#include "mesh/surface_mesh.h"

namespace mq::triangulate {

/// The longest edges that are wanted around one vertex, edge or face of the part.
struct LocalSize {
    int dimension = 2;  ///< 0 vertex, 1 edge, 2 face
    int index = 0;
    double max_edge = 0.0;  ///< mm
};

/// The same sizes for all pieces of what they are given for (Topology::parts_of).
/// @throws InvalidInput for what the shape does not have, and for a size of nothing, naming it
std::vector<LocalSize> sizes_of_pieces(const std::vector<LocalSize>& local, const geometry::Topology& topology);

/// How long an edge of the mesh may be: the least of the bounds for the whole part, the faces that it lies on or
/// borders, the CAD edge that it is a piece of, and the CAD vertices at which it ends.
class EdgeBounds {
  public:
    /// `max_edge` in mm; 0: no bound for the whole part. `local` is what `sizes_of_pieces` gives.
    EdgeBounds(const geometry::Topology& topology, double max_edge, const std::vector<LocalSize>& local);

    /// Whether there is any.
    bool any() const { return any_; }
    /// mm; infinite where there is none.
    double of(const mesh::SurfaceMesh& mesh, int half_edge) const;

  private:
    double everywhere_;
    std::vector<double> of_entity_[3];
    bool any_ = false;
};

}  // namespace mq::triangulate
