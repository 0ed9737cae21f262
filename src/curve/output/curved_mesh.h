// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/message.h"
#include "base/stopwatch.h"
#include "curve/surface/curved_surface.h"
#include "curve/volume/tetrahedral_mesh.h"
#include "mesh/io/export_mesh.h"
#include "mesh/io/output.h"
#include "mesh/quality/mesh_report.h"
#include "mesh/triangle_mesh.h"

namespace mq::curve {

/// Measurements of the curved mesh, and counts of its repairs. The comments are what Python says of the fields
/// (tools/bound_fields).
struct CurveReport {
    // The pairs of curved triangles are those of injectivity/curved_crossings.h.
    /// pairs of curved triangles that are proven to cross; -1: not looked for
    std::int64_t curved_intersections = -1;
    /// those of them of different bodies, which no node connects; -1: not looked for
    std::int64_t curved_overlaps = -1;
    /// pairs that are neither proven to cross nor to be apart, as where they touch; -1: not looked for
    std::int64_t not_proven_apart = -1;
    std::size_t elements = 0;                   ///< tetrahedra of a volume, triangles of a surface
    std::size_t vertices = 0;                   ///< corner vertices
    std::size_t invalid_before = 0;             ///< right after curving, before any repair
    std::size_t invalid = 0;                    ///< invalid elements of the final mesh
    std::vector<std::string> invalid_elements;  ///< [text, ...]: which these are, as "triangle 3 on Face1"
    double min_scaled_jacobian = 0.0;           ///< min J / J of the straight element
    double min_distortion = 0.0;                ///< min J / max J
    /// the largest of triangle_distortion or tetrahedron_distortion: 1 is the regular shape
    double max_shape_distortion = 0.0;
    double mean_distortion = 0.0;           ///< mean of min J / max J
    double max_deviation = 0.0;             ///< from the CAD faces, mm
    double rms_deviation = 0.0;             ///< likewise, the root of the mean square
    std::vector<std::string> straightened;  ///< [text, ...]: elements that were made straight
    double volume = 0.0;                    ///< that the curved triangles enclose, mm^3; 0 without a solid
    double cad_volume = 0.0;                ///< volume of the solids, mm^3; 0: unknown
    /// how far cad_volume may be off, mm^3: error of its integration, and of faces that meet within the tolerance of
    /// their edges
    double cad_volume_error = 0.0;
    std::size_t moved_vertices = 0;                            ///< corner vertices that a repair moved
    std::vector<std::pair<std::string, std::size_t>> repairs;  ///< {kind of repair: how many}
    std::vector<Message> notes;       ///< sentences about the shape and the mesh that a user should know
    StageTimes seconds;               ///< {stage: wall-clock seconds}
    double cpu_seconds = 0.0;         ///< processor time of all threads of the operation
    double chord_height_asked = 0.0;  ///< largest deviation that was requested, mm; 0: none
    /// largest distance of the ends of an edge, divided by the size field between them; -1: there was no size field
    double size_ratio = -1.0;
    Vec3 size_ratio_point = Vec3::Zero();  ///< float64 (3,): the middle between these ends
    double short_share = 0.0;              ///< fraction of the edges that are shorter than half of the size field there
    /// how the shape came from FreeCAD: "live", in place, or "stream", as a copy; "": there was none
    std::string bridge;
    mesh::MeshReport straight;  ///< MeshReport of the mesh that was curved

    /// |volume - cad_volume| / cad_volume; -1: unknown.
    double volume_error() const;
};

/// The result: nodes, and elements of one order in Gmsh's node order.
struct CurvedMesh {
    int order = 1;
    std::vector<Vec3> nodes;                      ///< the corner vertices come first
    std::vector<mesh::VertexEntity> node_entity;  ///< dimension 0 to 3 and index
    std::size_t vertices = 0;                     ///< how many of the nodes are corners
    /// Flat lists with a fixed number of nodes for each element.
    std::vector<std::int32_t> edges;  ///< mesh edges on CAD edges
    std::vector<std::int32_t> edge_entity;
    std::vector<std::int32_t> triangles;  ///< on CAD faces
    std::vector<std::int32_t> triangle_face;
    /// By triangle: the CAD face of the solid on its other side, where two solids touch; -1: none. Empty where none
    /// do.
    std::vector<std::int32_t> triangle_face_behind;
    std::vector<std::int32_t> tetrahedra;  ///< empty unless `volume` is set
    std::vector<std::int32_t> tetrahedron_volume;
    /// By triangle: lower bound of min / max of the normal component, against the CAD; not positive: invalid.
    std::vector<double> triangle_quality;
    /// By tetrahedron: lower bound of min J / J of the straight element; not positive: invalid.
    std::vector<double> tetrahedron_quality;
    /// Data on a mesh that another program made (given/curve_given.h), else empty: by corner, the given node; by
    /// element (by tetrahedron if there are any), the given element with the same corners; -1: none. The given nodes
    /// that moved.
    std::vector<std::int32_t> given_node;
    std::vector<std::int32_t> given_element;
    std::vector<std::int32_t> moved_nodes;
    mesh::TriangleMesh straight;  ///< the mesh that was curved; empty where that is not known
    CurveReport report;

    int nodes_per_edge() const { return elements::Lattice::of(1, order).size(); }
    int nodes_per_triangle() const { return elements::Lattice::of(2, order).size(); }
    int nodes_per_tetrahedron() const { return elements::Lattice::of(3, order).size(); }
};

/// By triangle: a tetrahedron that it is a face of, the one of lowest index; -1 where there is none.
std::vector<std::int32_t> tetrahedra_behind(const CurvedMesh& mesh);

/// Numbers the nodes of a surface and of the tetrahedra in it, and lists all elements. Vertices no element uses are
/// left out.
/// @param number  gets the node of each vertex of the surface, -1 where it is left out
CurvedMesh assemble(const CurvedSurface& surface, const std::vector<Tetrahedron>& tetrahedra,
                    std::vector<int>* number = nullptr);

/// Changes the entities from pieces of faces that are cut along creases to those of the original shape
/// (Topology::of_shape). Creases are no elements then.
void classify_on_original_entities(CurvedMesh& mesh, const geometry::Topology& topology);

/// Checks the conditions on which the functions below rely, for a mesh of another program: a supported order, finite
/// nodes of a size that SinglePrecisionGrid accepts, known entities, elements with complete rows of known nodes and one
/// entity each, and one quality each or none.
/// @throws InvalidInput naming the list that is wrong.
void require_sound(const CurvedMesh& mesh);

/// The mesh as writers see it, grouped by its patches or, without patches, by CAD face; edges and solids are groups by
/// name.
/// @throws InvalidInput where there is not one patch for each triangle
mesh::ExportMesh exported(const CurvedMesh& mesh, const mesh::Patches& patches = {}, double scale = 1.0);

/// A text of a dozen lines for people.
std::string to_text(const CurveReport& report);

}  // namespace mq::curve
