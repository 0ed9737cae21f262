// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/progress.h"
#include "geometry/engine.h"
#include "mesh/report.h"
#include "mesh/triangle_mesh.h"
#include "triangulate/edge_bounds.h"

/// Quality triangulation of CAD parts behind one function: Aftosmis 1999, Algorithms M and E, and the
/// curvature-sensitive sampling of Ruiz et al.
namespace mq::triangulate {

/// Where a triangle with too small an angle gets its new vertex.
enum class Insertion {
    OffCentre,  ///< at the off-centre: fewer triangles, and no cascades along finely split edges
    Paper,  ///< as Aftosmis 1999, section 3.3: circumcentre, or the centroid of the triangle across the longest edge
};

/// Where the vertices come from.
enum class Method {
    Refine,    ///< Algorithms M and E (Aftosmis 1999)
    Star,      ///< hexagons in the tangent planes, sized by the curvature (Ruiz et al., section 2.4)
    Sprinkle,  ///< random points with balls sized by the curvature (Ruiz et al., section 2.3)
};

/// How samples are joined to triangles.
enum class Connectivity {
    PseudoDelaunay,  ///< in space, by empty balls (Ruiz et al., section 2.5)
    Parametric,      ///< constrained Delaunay in (u, v), scaled
};

/// Which CAD edges constrain the mesh.
enum class KeepEdges {
    All,      ///< every one (Aftosmis 1999)
    Feature,  ///< not those that the surface crosses smoothly: triangles may span them
};

struct Options {
    double min_angle = 25.0;             ///< degrees, 0 < a <= 34
    double chord_height = 0.0;           ///< mm; 0: no bound
    double chord_height_relative = 0.0;  ///< fraction of the part's largest dimension; 0: no bound
    double max_edge = 0.0;               ///< mm; 0: no bound
    double min_edge = 0.0;  ///< mm; no edge is split into shorter ones, but to part what crosses; 0: no bound
    std::vector<LocalSize> local_sizes;  ///< shorter edges in places
    double edges_per_circle = 0.0;  ///< of any curve and surface: by a turn of 360 degrees; at least 3; 0: no bound
    double growth = 0.0;            ///< from edges to those beside them, more than 1; 0: no bound
    Insertion insertion = Insertion::OffCentre;
    KeepEdges keep_edges = KeepEdges::All;
    double feature_angle = 10.0;    ///< degrees, 0 < a <= 40; an edge is smooth where the faces' normals differ by less
    std::size_t max_triangles = 0;  ///< 0: 5 million
    bool allow_missing_faces = false;  ///< mesh the rest of a part whose faces fail, and name them in the report
    Method method = Method::Refine;

    // Of the sampling methods only:
    Connectivity connectivity = Connectivity::PseudoDelaunay;
    bool polish = true;      ///< swaps and rounds of Algorithms M and E follow, so that the bounds hold
    std::uint64_t seed = 0;  ///< of the Sprinkle method

    /// The bounds hold on the result, not only on the samples.
    bool keeps_bounds() const { return method == Method::Refine || polish; }
    std::size_t budget() const { return max_triangles > 0 ? max_triangles : 5'000'000; }
    /// @throws InvalidInput naming the option, its value and its range.
    void validate() const;
};

class Memory;

struct Result {
    mesh::TriangleMesh mesh;
    mesh::MeshReport report;
};

/// Meshes all volumes of a part.
///
/// Guarantees: every angle is at least `min_angle` except in the triangles listed in the report (not without `polish`);
/// every vertex is a single-precision point; ends for every input.
///
/// The `memory` gets what this run leaves, unless it is null. The very same input as in a run that it holds gets that
/// run's result. Else faces that were meshed before start as they were, where the same is asked for: the guarantees are
/// the same, but the mesh depends on what was remembered. Where that misses more than the mesh before the edit did, all
/// is done from nothing. No face is remembered with samples, nor where smooth edges
/// are released.
/// @throws InvalidInput, TopologyError, GeometryError naming the entity; Cancelled.
Result triangulate(geometry::Engine& engine, const std::shared_ptr<geometry::Model>& model, const Options& options = {},
                   Progress* progress = nullptr, Memory* memory = nullptr);

}  // namespace mq::triangulate
