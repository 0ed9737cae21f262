// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.h"
#include "base/stopwatch.h"
#include "mesh/quality/exempt_reason.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// How many pairs of triangles of two CAD faces, or of one, cross.
struct FaceCrossing {
    std::array<std::int32_t, 2> faces{};
    std::size_t pairs = 0;
};

/// Where two solids touch: the triangles that they share.
struct SolidContact {
    std::array<std::int32_t, 2> solids{};  ///< numbers in the shape, ascending, from 0 on; -1: it is no solid
    std::size_t triangles = 0;             ///< on one side
    double area = 0.0;                     ///< mm^2
};

/// Two bodies of a shape, solids or shells, of which the meshes are not apart.
struct BodyOverlap {
    enum class Kind {
        Overlapping,  ///< they share a volume, or their surfaces cross
        Inside,       ///< the first one lies in the second one
        Equal,        ///< they are the same body twice
        Near,         ///< they are apart in the shape, but their triangles cross
    };
    std::array<std::string, 2> bodies;  ///< "Solid2"; of a shell one of its faces: "Face7"
    Kind kind = Kind::Overlapping;
};

/// "overlapping", "inside", "equal", "near"
const char* to_string(BodyOverlap::Kind kind);

/// The measured properties of the final mesh, and the notes of the operation. Angles in degrees, lengths in mm.
struct MeshReport {
    std::size_t triangles = 0;
    std::size_t vertices = 0;
    bool closed = false;    ///< no border edge
    bool oriented = false;  ///< every inner edge is run once each way
    bool manifold = false;  ///< no edge with three or more triangles, no pinched vertex, no degenerate triangle
    std::size_t border_edges = 0;
    std::size_t nonmanifold_edges = 0;
    std::size_t misoriented_edges = 0;
    std::size_t pinched_vertices = 0;
    std::size_t degenerate_triangles = 0;  ///< two equal corners, or corners on one line
    std::size_t duplicate_triangles = 0;
    std::size_t components = 0;
    long euler = 0;  ///< V - E + F
    double min_angle = 0.0;
    double max_angle = 0.0;
    double mean_min_angle = 0.0;  ///< mean over the triangles of their smallest angle
    double max_aspect = 0.0;      ///< longest edge / shortest edge of one triangle
    /// Largest ratio of the longest edges of two triangles with a common edge: how fast the size changes.
    double max_stretching = 0.0;
    std::size_t max_degree = 0;                     ///< largest number of edges at a vertex
    std::array<std::size_t, 60> angle_histogram{};  ///< smallest angle of each triangle, one bin a degree
    double area = 0.0;
    double volume = 0.0;  ///< signed volume, mm^3; for closed meshes only
    Box box;

    double min_angle_asked = 0.0;
    double min_angle_unexempted = 0.0;  ///< smallest angle over triangles that are not in `exempt`
    double max_chord_height = -1.0;     ///< largest measured distance to the CAD; -1 when there is no CAD
    /// Whether max_chord_height is the distance to the nearest of all faces, not to each triangle's own one.
    bool to_nearest_face = false;
    std::int32_t max_chord_triangle = -1;  ///< triangle with the largest distance; -1: not known
    Vec3 max_chord_point = Vec3::Zero();   ///< point of the mesh with the largest distance, in the model's frame
    double chord_height_asked = 0.0;       ///< requested limit of the distance; 0: none
    double detail = 0.0;     ///< shorter CAD edges and thinner CAD faces were not told apart where that is safe, mm
    bool imprinted = false;  ///< solids that touch have the same triangles on both sides
    bool sewn = false;       ///< CAD faces without a shell were joined where their borders lie together within `detail`
    /// Pairs of triangles of one volume that meet elsewhere than in their common vertices and edges, and of loose faces
    /// that cross; -1: not searched.
    std::int64_t self_intersections = -1;
    /// Pairs of triangles of different volumes that cross, but for those of volumes that only touch; -1: not searched
    std::int64_t overlaps = -1;
    std::vector<BodyOverlap> overlapping_bodies;
    std::vector<std::pair<std::int32_t, ExemptReason>> exempt;   ///< triangle, why its angle is below the bound
    std::vector<std::pair<std::int32_t, std::string>> spanning;  ///< triangle, which CAD faces it lies on
    std::vector<std::pair<std::int32_t, std::string>> fallback;  ///< CAD face, why its samples were joined in (u, v)
    std::vector<std::pair<std::int32_t, std::string>> missing;   ///< CAD face that has no triangles, why
    std::vector<SolidContact> contacts;                          ///< where solids share triangles
    std::vector<FaceCrossing> crossings;                         ///< by pair of CAD faces: the self-intersections
    std::vector<std::string> notes;  ///< what the reader must know: faults of the model, budget reached, ...
    bool complete = true;            ///< false when a budget ended the work early

    std::size_t reused_faces = 0;  ///< CAD faces whose triangles are all taken from the run before

    StageTimes seconds;
    double cpu_seconds = 0.0;
    std::uint64_t queries = 0;
    std::uint64_t predicates = 0;
    std::uint64_t exact_predicates = 0;  ///< predicates that needed exact arithmetic
};

/// Measures all properties that depend on the mesh alone (all fields up to `box`). Time O(n log n).
/// @throws InvalidInput for a triangle that names a vertex out of range or a coordinate that is not a number.
/// @throws Cancelled when `progress` says so.
MeshReport measure(const TriangleMesh& mesh, const Progress* progress = nullptr);

/// Twice the volume divided by the area, mm: the thickness of a plate, the radius of a long rod; 0 if there is no area.
double mean_thickness(const TriangleMesh& mesh);

/// Connectivity of a surface.
struct SurfaceTopology {
    std::size_t components = 0;  ///< pieces that are connected by edges
    long euler = 0;              ///< V - E + F
};

/// The same two numbers as in a MeshReport, computed in a fraction of its time. The mesh must be valid.
SurfaceTopology topology_of(const TriangleMesh& mesh);

/// A text of a dozen lines for people.
std::string to_text(const MeshReport& report);

/// A summary in one line: "1,234 triangles, closed, smallest angle 25.1°".
std::string in_short(const MeshReport& report);

/// Whether the mesh has faults that no mesh should have, or violates a limit that was requested.
bool has_faults(const MeshReport& report);

/// "1,234 triangles", "1 triangle".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace mq::mesh
