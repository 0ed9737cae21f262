// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
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

/// The measured properties of the final mesh, and the notes of the operation. Angles in degrees, lengths in mm. The
/// comments are what Python says of the fields (tools/bound_fields).
struct MeshReport {
    std::size_t triangles = 0;     ///< number of triangles
    std::size_t vertices = 0;      ///< number of vertices
    bool closed = false;           ///< no border edge
    bool oriented = false;         ///< every inner edge is run once each way
    bool manifold = false;         ///< no edge of three or more triangles, no pinched vertex, no degenerate triangle
    std::size_t border_edges = 0;  ///< edges of one triangle
    std::size_t nonmanifold_edges = 0;     ///< edges of three or more triangles
    std::size_t misoriented_edges = 0;     ///< inner edges that both triangles run the same way
    std::size_t pinched_vertices = 0;      ///< vertices whose triangles form more than one fan
    std::size_t degenerate_triangles = 0;  ///< triangles without area
    std::size_t duplicate_triangles = 0;   ///< triangles with the vertices of another one
    std::size_t components = 0;            ///< pieces that hang together by edges
    long euler = 0;                        ///< vertices - edges + triangles
    double min_angle = 0.0;                ///< smallest angle of all triangles
    double max_angle = 0.0;                ///< largest angle of all triangles
    double mean_min_angle = 0.0;           ///< mean of the triangles' smallest angles
    double max_aspect = 0.0;               ///< longest edge / shortest edge of one triangle
    /// largest ratio of the longest edges of two triangles with a common edge: how fast the size changes; 0 for a mesh
    /// without such
    double max_stretching = 0.0;
    std::size_t max_degree = 0;                     ///< largest number of edges at a vertex
    std::array<std::size_t, 60> angle_histogram{};  ///< smallest angle of each triangle, 60 bins of one degree
    double area = 0.0;                              ///< mm^2
    double volume = 0.0;                            ///< mm^3, signed; 0 unless closed
    Box box;                                        ///< (low, high), or None for an empty mesh

    double min_angle_asked = 0.0;          ///< the bound; 0: none
    double min_angle_unexempted = 0.0;     ///< smallest angle over the triangles that are not in exempt
    double max_chord_height = -1.0;        ///< largest measured distance to the CAD, mm; -1 when there is no CAD
    bool to_nearest_face = false;          // see max_chord_height_to
    std::int32_t max_chord_triangle = -1;  ///< the triangle where that is; -1: not known
    /// float64 (3,): the point of that triangle where that is, with the mesh's origin
    Vec3 max_chord_point = Vec3::Zero();
    double chord_height_asked = 0.0;  ///< mm; 0: none
    /// about the number of triangles that this distance alone asks for, without bounds on angles; 0: not known
    std::size_t chord_triangles = 0;
    /// largest length of an edge, divided by the size field at its middle; -1: there was no size field
    double size_ratio = -1.0;
    Vec3 size_ratio_point = Vec3::Zero();  ///< float64 (3,): the middle of that edge
    double short_share = 0.0;  ///< fraction of the edges that are shorter than half of the size field at their middles
    /// mm: shorter edges and thinner faces of the shape were not told apart where that is safe; 0: all were
    double detail = 0.0;
    std::size_t cut_corners = 0;  ///< narrow corners of faces that were cut off
    bool cut_pinches = false;     ///< whether only those were with which the bound on angles is not kept
    bool sewn = false;  ///< whether faces without a shell were joined where their borders lie together within `detail`
    bool imprinted = false;  ///< whether solids that touch have the same triangles on both sides
    /// pairs of triangles of one volume that meet elsewhere than in their common vertices and edges, and of loose faces
    /// that cross; counted up to MOST_CROSSINGS; -1: not looked for
    std::int64_t self_intersections = -1;
    /// pairs of triangles of different volumes, such as the solids of an assembly, that cross, but for those of bodies
    /// that only touch; -1: not looked for
    std::int64_t overlaps = -1;
    /// [(body, body, how), ...], bodies by their names, of shells one of their faces; how: "overlapping"; "inside": the
    /// first lies in the second; "equal": one body twice; "near": apart in the shape, but their triangles cross
    std::vector<BodyOverlap> overlapping_bodies;
    /// [(triangle, reason), ...]: the same as data: reason.cause, .forced (by the shape itself), .angle (of the corner
    /// that causes it in degrees, or -1), .entities (names of the edges, the vertex and the face), .joined (names of
    /// two that count as one) and .apart (their distance in mm, or -1)
    std::vector<std::pair<std::int32_t, ExemptReason>> exempt;
    /// [(triangle, the CAD faces that it lies on), ...], of keep_edges = feature; its own face is that with the largest
    /// share
    std::vector<std::pair<std::int32_t, std::string>> spanning;
    /// [(CAD face, why it has no triangles), ...], of allow_missing_faces
    std::vector<std::pair<std::int32_t, std::string>> missing;
    /// [(CAD face, CAD face, pairs of their triangles that cross), ...]
    std::vector<FaceCrossing> crossings;
    /// [(solid, solid, triangles on one side, mm^2), ...]: where solids share triangles, by their numbers in
    /// shape.Solids; see imprint
    std::vector<SolidContact> contacts;
    /// [(face, why its samples were joined in (u, v) instead of in space), ...]
    std::vector<std::pair<std::int32_t, std::string>> fallback;
    std::vector<Message> notes;  ///< sentences about the shape and the mesh that a user should know
    /// how the shape came from FreeCAD: "live", in place, or "stream", as a copy; "": there was none
    std::string bridge;
    bool complete = true;                ///< False when a limit ended the work early
    StageTimes seconds;                  ///< {stage: wall-clock seconds}
    double cpu_seconds = 0.0;            ///< processor time of all threads of the operation
    std::size_t reused_faces = 0;        ///< CAD faces that kept the triangles of the run before
    std::uint64_t queries = 0;           ///< queries to the geometry engine
    std::uint64_t predicates = 0;        ///< geometric predicates that were evaluated
    std::uint64_t exact_predicates = 0;  ///< predicates that needed exact arithmetic
};

/// The promised bound on MeshReport::size_ratio.
constexpr double kMostOfSizeField = 1.3;

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

/// The components and the Euler number as in a MeshReport, in a fraction of its time. The mesh must be valid.
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
