// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "base/sizes/size_field.h"
#include "geometry/topology.h"
#include "triangulate/work_mesh/classified_mesh.h"

namespace mq::triangulate {

/// A bound on the length of edges around one vertex, edge or face of the shape.
struct LocalSize {
    int dimension = 2;  ///< 0 vertex, 1 edge, 2 face
    int index = 0;
    double max_edge = 0.0;  ///< mm
};

/// Returns the same sizes for all pieces of the entities they are given for (Topology::pieces_of).
/// @throws InvalidInput naming an entity that the shape does not have, or whose size is not above 0
std::vector<LocalSize> sizes_of_pieces(const std::vector<LocalSize>& local, const geometry::Topology& topology);

/// Bounds on the length of an edge of the mesh: the least of those for the whole shape, the faces that it lies on or
/// borders, the CAD edge that it is a piece of, the CAD vertices at which it ends, and a size field at its middle.
class EdgeBounds {
  public:
    /// `max_edge` in mm; 0: no bound for the whole shape. `local`: the result of `sizes_of_pieces`.
    EdgeBounds(const geometry::Topology& topology, double max_edge, const std::vector<LocalSize>& local);

    /// Adds a size field; null: none. `origin`: that of the mesh in the coordinates of the field, mm.
    void set_field(std::shared_ptr<const SizeField> field, const Vec3& origin) {
        any_ = any_ || field != nullptr;
        field_ = std::move(field);
        origin_ = origin;
    }

    /// Whether there is any bound.
    bool any() const { return any_; }
    /// Returns the bound for an edge, mm; infinite if there is none.
    double of(const ClassifiedMesh& mesh, int half_edge) const;

    /// Returns the bound that the size field sets for an edge by all points of the triangles beside it: small regions
    /// are found though no middle of an edge lies in them. `length` of the edge, mm; infinite where that is within the
    /// bound.
    double by_triangles(const ClassifiedMesh& mesh, int half_edge, double length) const;

  private:
    double everywhere_;
    std::vector<double> of_entity_[3];
    bool any_ = false;
    std::shared_ptr<const SizeField> field_;
    Vec3 origin_ = Vec3::Zero();
};

/// The bounds on the size of triangles.
struct Sizing {
    double tolerance = 0.0;     ///< largest distance from the CAD model, mm; 0: no bound
    EdgeBounds bounds;          ///< largest lengths of edges
    double turn = 0.0;          ///< radians: largest turn of the normal along an edge; 0: no bound
    double growth = 0.0;        ///< largest ratio of lengths of neighbouring edges (see graded_sizes); 0: no bound
    double whole_corner = 0.0;  ///< radians: corners of the border below this have no room for two triangles

    bool any() const { return tolerance > 0.0 || bounds.any() || turn > 0.0 || growth > 0.0; }
};

}  // namespace mq::triangulate
