// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "base/progress.h"
#include "geometry/engine.h"
#include "mesh/report.h"
#include "mesh/triangle_mesh.h"

/// Quality triangulation of CAD parts: Aftosmis 1999, Algorithms M and E, behind one function.
namespace mq::triangulate {

/// Where a triangle with too small an angle gets its new vertex.
enum class Insertion {
    OffCentre,  ///< at the off-centre: fewer triangles, and no cascades along finely split edges
    Paper,  ///< as Aftosmis 1999, section 3.3: circumcentre, or the centroid of the triangle across the longest edge
};

struct Options {
    double min_angle = 25.0;             ///< degrees, 0 < a <= 34
    double chord_height = 0.0;           ///< mm; 0: no bound
    double chord_height_relative = 0.0;  ///< fraction of the part's largest dimension; 0: no bound
    double max_edge = 0.0;               ///< mm; 0: no bound
    double min_edge = 0.0;               ///< mm; no edge is split into shorter ones than this; 0: no bound
    Insertion insertion = Insertion::OffCentre;
    std::size_t max_triangles = 0;     ///< 0: 5 million
    bool allow_missing_faces = false;  ///< mesh the rest of a part whose faces fail, and name them in the report

    /// @throws InvalidInput naming the option, its value and its range.
    void validate() const;
};

struct Result {
    mesh::TriangleMesh mesh;
    mesh::MeshReport report;
};

/// Meshes all volumes of a part.
///
/// Guarantees: every angle is at least `min_angle` except in the triangles listed in the report; every vertex is a
/// single-precision point; ends for every input.
/// @throws InvalidInput, TopologyError, GeometryError naming the entity; Cancelled.
Result triangulate(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model, const Options& options = {},
                   Progress* progress = nullptr);

}  // namespace mq::triangulate
