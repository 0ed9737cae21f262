// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/sizes/size_field.h"
#include "base/vec.h"
#include "geometry/detail.h"
#include "geometry/evaluation.h"
#include "geometry/topology.h"
#include "triangulate/work_mesh/size_bounds.h"

namespace mq::triangulate {

/// Rules for the new vertex of a triangle whose angle is below the bound.
enum class Insertion {
    OffCentre,     ///< at the off-centre: fewer triangles, and no cascades along finely split edges
    Circumcentre,  ///< as Aftosmis 1999, section 3.3: circumcentre, or the centroid of the triangle across the longest
                   ///< edge
};

/// Orders in which triangles whose angles are below the bound get their vertices.
enum class Order {
    Rounds,     ///< many in a round: their surface points are found by several threads
    WorstFirst  ///< one after the other (Aftosmis 1999, section 3.3); for Insertion::Circumcentre
};

/// Sources of the vertices.
enum class Method {
    Refine,    ///< Algorithms M and E (Aftosmis 1999)
    Star,      ///< hexagons in the tangent planes, sized by the curvature (Ruiz et al., section 2.4)
    Sprinkle,  ///< random points with balls sized by the curvature (Ruiz et al., section 2.3)
};

/// Rules for joining samples to triangles.
enum class Connectivity {
    PseudoDelaunay,  ///< in space, by empty balls (Ruiz et al., section 2.5)
    Parametric,      ///< constrained Delaunay in (u, v), scaled
};

/// The CAD edges that constrain the mesh.
enum class KeepEdges {
    All,      ///< every one (Aftosmis 1999)
    Feature,  ///< all except those that the surface crosses smoothly: triangles may span them
};

/// What becomes of corners of faces that are narrower than the bound on angles.
enum class Corners {
    Auto,  ///< they are cut off where the bound is not kept with them (geometry::CornerCuts::Infeasible), and all of
           ///< them where refinement leaves further triangles below the bound
    Keep,  ///< each keeps one triangle with the angle of the shape
    Cut,   ///< they are cut off where they are a detail wide, and keep the bound, where the faces beside allow it
};

struct TriangulateOptions {
    double min_angle = 25.0;             ///< degrees, 0 <= a <= 34; 0: no bound
    double chord_height = 0.0;           ///< mm; 0: no bound
    double chord_height_relative = 0.0;  ///< fraction of the shape's largest dimension; 0: no bound
    double max_edge = 0.0;               ///< mm; 0: no bound
    /// mm: no edge is split into edges shorter than this, except to separate crossing triangles; 0: no bound.
    double min_edge = 0.0;
    std::vector<LocalSize> local_sizes;  ///< shorter edges on single entities
    /// Lengths of edges by their places, in the shape's coordinates; null: none.
    std::shared_ptr<const SizeField> size_field;
    double edges_per_circle = 0.0;  ///< edges in a turn of 360 degrees of any curve or surface; at least 3; 0: no bound
    double growth = 0.0;            ///< largest ratio of lengths of neighbouring edges, more than 1; 0: no bound
    Insertion insertion = Insertion::OffCentre;
    Order order = Order::Rounds;
    KeepEdges keep_edges = KeepEdges::All;
    double feature_angle = 10.0;  ///< degrees, 0 < a <= 40; an edge is smooth if the faces' normals differ by less
    Corners corners = Corners::Auto;
    std::size_t max_triangles = 0;  ///< 0: 5 million
    /// End where the first refinement of angles makes more triangles than this, more than twenty for each that it
    /// begins with, and more than twice those that the distance seems to ask for: the result is then not complete. 0:
    /// never.
    std::size_t costly_above = 0;
    bool allow_missing_faces = false;  ///< mesh the other faces of a shape if some fail, and name those in the report
    bool sew = true;                   ///< join faces without a shell where their borders lie together
    bool imprint = false;              ///< the same triangles on both sides where solids touch
    Method method = Method::Refine;
    /// Threads that work at a time; 0: one for each core, or as many as MESHQUALITY_THREADS says. The result is the
    /// same for any number.
    int threads = 0;

    // For comparisons with Aftosmis 1999:
    geometry::Evaluation evaluation = geometry::Evaluation::Fast;  ///< Native: OpenCASCADE alone
    /// New vertices in a round of Algorithm M; 1: one after the other; 0: by the queue.
    std::size_t sites_in_round = 0;
    bool record_angles = false;  ///< fill Result::angle_history

    // For the sampling methods only:
    Connectivity connectivity = Connectivity::PseudoDelaunay;
    bool polish = true;      ///< swaps and rounds of Algorithms M and E follow, so that the bounds hold
    std::uint64_t seed = 0;  ///< start of the random numbers of the Sprinkle method

    /// Whether the bounds hold for the result, not only for the samples.
    /// The narrow corners that are cut off before refinement.
    geometry::CornerCuts corner_cuts() const;
    bool keeps_bounds() const { return method == Method::Refine || polish; }
    std::size_t budget() const { return max_triangles > 0 ? max_triangles : 5'000'000; }
    /// The tolerance of the chord height for a shape of this box, mm; 0: no bound.
    double chord_height_of(const Box& box) const;
    /// mm: the largest length of a detail, in place of the one by the requested tolerance and lengths; 0: that one.
    double detail = 0.0;
    /// Largest length of a detail, as a fraction of the shape's size, and of the requested tolerance or edge lengths.
    static constexpr double kLargestDetail = 1e-4;
    static constexpr double kDetailOfWhatIsAsked = geometry::kDetailOfWhatIsAsked;
    /// The length below which edges and faces of a shape of this box show neither at the requested tolerance nor at the
    /// requested sizes, mm.
    double detail_of(const Box& box) const;
    /// Checks all options. @throws InvalidInput naming the option, its value and its range.
    void validate() const;
};

}  // namespace mq::triangulate
